// Looks a row of a table up by its name.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text.h"

namespace ssrkit {

// Fails with the nearest name, or the list; `kind` is the word for a row: "stage".
template <class Row>
[[nodiscard]] Expected<const Row*> findRow(std::span<const Row> rows, std::string_view name,
                                           std::string_view kind) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  if (found != rows.end()) {
    return &*found;
  }
  std::vector<std::string> names;
  for (const Row& row : rows) {
    names.push_back(row.name);
  }
  const auto nearest = nearestName(name, names);
  return inputError(fmt::format("find the {} '{}'", kind, name), fmt::format("there is no such {}", kind), "",
                    nearest ? fmt::format("did you mean '{}'?", *nearest)
                            : fmt::format("the {}s are {}", kind, joinNames(names)));
}

}  // namespace ssrkit
