// DIR/report.html: every check of a run in one page that opens from the disk, without a network. A table to
// filter, a matrix of checks and devices, the whole message of each check, and pictures of where the first
// failures are.
#pragma once

#include <string>

#include "base/error.h"
#include "report/run_report.h"

namespace ssrkit {

// The page. Fails only where the PNG encoder is not installed.
[[nodiscard]] Expected<std::string> checksHtml(const RunReport& report);

}  // namespace ssrkit
