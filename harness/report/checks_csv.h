// DIR/checks.csv (docs/formats.md): one row a check, as RFC 4180 writes them, for spreadsheets and data
// frames.
#pragma once

#include <string>

#include "report/run_report.h"

namespace ssrkit {

// A header, then a row a check. Empty fields were not measured; numbers read back as they were.
[[nodiscard]] std::string checksCsv(const RunReport& report);

}  // namespace ssrkit
