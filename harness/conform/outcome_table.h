// The matrix as text: a row a check, a column a device.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "conform/cell_record.h"

namespace ssrkit {

// For each test a heading, and below it a row for each of its expectations; where not everything passed, a
// row for each stage. A field holds the number of checks that passed; "3/40 fail" where three did not, with
// the gravest outcome among them; "skip" where all were skipped; "-" where the check is not asked of the
// device. At most 100 columns wide, with up to seven devices of names like "vk-swiftshader". Ends with a line
// feed.
[[nodiscard]] std::string outcomeTable(std::span<const CellRecord> records, bool colour);

}  // namespace ssrkit
