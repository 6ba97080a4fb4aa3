#include "spaces/trace_parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>
#include <vector>

#include "base/check.h"
#include "base/text.h"

namespace ssrkit {

namespace {

using Field = std::variant<double TraceParameters::*, int TraceParameters::*, TracerForm TraceParameters::*>;

struct Row {
  std::string name;
  Field field;
  double least = 0.0;
  double most = 0.0;
  bool may_be_infinite = false;
};

const std::vector<Row>& rows() {
  constexpr double kManyMetres = 1e9;
  // The sum of a fragment's loop iterations stays under Mesa's silent cap of 65,535.
  constexpr double kManyLookups = 60000;
  static const std::vector<Row> table = {
      {"thickness_m", &TraceParameters::thickness_m, 0.0, kManyMetres, true},
      {"thickness_rel", &TraceParameters::thickness_rel, 0.0, 1e3},
      {"max_distance_m", &TraceParameters::max_distance_m, 1e-6, kManyMetres, true},
      {"origin_bias", &TraceParameters::origin_bias, 0.0, 1.0},
      {"lookup_budget", &TraceParameters::lookup_budget, 0.0, kManyLookups},
      {"step_count", &TraceParameters::step_count, 0.0, kMaxStepCount},
      {"step_m", &TraceParameters::step_m, 0.0, kManyMetres},
      {"bisection_count", &TraceParameters::bisection_count, -1.0, 32.0},
      {"stride_px", &TraceParameters::stride_px, 1.0, 1024.0},
      {"jitter", &TraceParameters::jitter, 0.0, 1.0},
      {"max_mip", &TraceParameters::max_mip, -1.0, 14.0},
      {"step_growth", &TraceParameters::step_growth, 1.0, 4.0},
      {"form", &TraceParameters::form},
  };
  return table;
}

const Row* findRow(std::string_view name) {
  for (const Row& row : rows()) {
    if (row.name == name) {
      return &row;
    }
  }
  return nullptr;
}

tl::unexpected<Error> badValue(const Row& row, std::string_view value, const std::string& expected,
                               const std::string& where) {
  return inputError(fmt::format("set the parameter '{}'", row.name),
                    fmt::format("'{}' is not {}", value, expected), where);
}

std::string rangeText(const Row& row) {
  return fmt::format("a number from {} to {}{}", row.least, row.most, row.may_be_infinite ? ", or inf" : "");
}

Expected<double> numberInRange(const Row& row, std::string_view text, const std::string& where) {
  const std::optional<double> number = parseNumber(text);
  const bool is_infinite = number && std::isinf(*number) && *number > 0.0;
  if (!number || std::isnan(*number) || (is_infinite && !row.may_be_infinite) ||
      (!is_infinite && (*number < row.least || *number > row.most))) {
    return badValue(row, text, rangeText(row), where);
  }
  return *number;
}

}  // namespace

Expected<void> setParameter(TraceParameters& parameters, std::string_view name, std::string_view value,
                            const std::string& where) {
  const Row* row = findRow(name);
  if (row == nullptr) {
    const std::optional<std::string> nearest = nearestName(name, parameterNames());
    return inputError(fmt::format("set the parameter '{}'", name), "there is no such parameter", where,
                      nearest ? fmt::format("did you mean '{}'?", *nearest)
                              : "the parameters are " + joinNames(parameterNames()));
  }
  if (const auto* form = std::get_if<TracerForm TraceParameters::*>(&row->field)) {
    if (value != "textbook" && value != "tuned") {
      return badValue(*row, value, "'textbook' or 'tuned'", where);
    }
    parameters.** form = value == "tuned" ? TracerForm::kTuned : TracerForm::kTextbook;
    return {};
  }
  const Expected<double> number = numberInRange(*row, value, where);
  if (!number) {
    return tl::make_unexpected(number.error());
  }
  if (const auto* real = std::get_if<double TraceParameters::*>(&row->field)) {
    parameters.** real = *number;
    return {};
  }
  if (*number != std::floor(*number)) {
    return badValue(*row, value, "a whole number", where);
  }
  parameters.*std::get<int TraceParameters::*>(row->field) = static_cast<int>(*number);
  return {};
}

bool isThicknessRelativeAlone(const ParameterList& written) {
  bool is_relative = false;
  for (const auto& [name, value] : written) {
    if (name == "thickness_m") {
      return false;
    }
    if (name == "thickness_rel") {
      is_relative = parseNumber(value).value_or(0.0) > 0.0;
    }
  }
  return is_relative;
}

std::span<const std::string> parameterNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Row& row : rows()) {
      list.push_back(row.name);
    }
    return list;
  }();
  return names;
}

std::string parameterText(const TraceParameters& parameters, std::string_view name) {
  const Row* row = findRow(name);
  SSRKIT_CHECK(row != nullptr);
  if (const auto* real = std::get_if<double TraceParameters::*>(&row->field)) {
    return fmt::format("{}", parameters.**real);
  }
  if (const auto* whole = std::get_if<int TraceParameters::*>(&row->field)) {
    return fmt::format("{}", parameters.**whole);
  }
  return parameters.form == TracerForm::kTuned ? "tuned" : "textbook";
}

}  // namespace ssrkit
