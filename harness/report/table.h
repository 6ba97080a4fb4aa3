// The table that a run prints.
#pragma once

#include <span>
#include <string>

#include "report/run_report.h"

namespace ssrkit {

struct TableStyle {
  bool colour = false;  // on outcome words only
  int width = 100;      // columns
};

// A terminal that wants colours: `fd` is one, TERM is not "dumb", and NO_COLOR is not set (no-color.org).
[[nodiscard]] bool wantsColour(int fd);

// A header, then for each scene, size and case a heading and one line for each stage and device, in the
// order given. Numbers are right-aligned, "-" stands for what was not measured. Ends with a line feed; empty
// without rows.
[[nodiscard]] std::string runTable(std::span<const RunRow> rows, const TableStyle& style);

}  // namespace ssrkit
