// What more than one JSON file holds.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "report/run_report.h"

namespace ssrkit {

using Json = nlohmann::ordered_json;

// Numbers that JSON cannot write are the strings "inf", "-inf" and "nan"; what was not measured is null.
[[nodiscard]] Json numberOf(double value);
[[nodiscard]] Json numberOf(const std::optional<double>& value);

[[nodiscard]] Json sizeOf(Size size);  // [640, 360]
[[nodiscard]] Json parametersOf(const TraceParameters& parameters);
[[nodiscard]] Json deviceOf(const DeviceRow& device);
[[nodiscard]] Json passesOf(const std::vector<PassReport>& passes);

// One entry a row. `List` is a parameter so that this header can do without the definition of Json.
template <class Rows, class Convert, class List = Json>
[[nodiscard]] List listOf(const Rows& rows, const Convert& convert) {
  List list = List::array();
  for (const auto& row : rows) {
    list.push_back(convert(row));
  }
  return list;
}

}  // namespace ssrkit
