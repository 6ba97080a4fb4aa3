// Every file that tells of a run's checks, in the forms that different readers want (docs/formats.md).
#pragma once

#include <filesystem>

#include "base/error.h"
#include "report/run_report.h"

namespace ssrkit {

// results.json, checks.csv, junit.xml and report.html in `folder`; each whole or not at all.
[[nodiscard]] Expected<void> writeReportFiles(const std::filesystem::path& folder, const RunReport& report);

}  // namespace ssrkit
