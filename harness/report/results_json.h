// DIR/results.json (docs/formats.md).
//
// Numbers that JSON cannot write are the strings "inf", "-inf" and "nan"; what was not measured is null.
// Bytes that are no UTF-8 (a driver's message) become U+FFFD.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "report/run_report.h"

namespace ssrkit {

// Raised when a reader of the older version would be misled.
inline constexpr int kResultsSchemaVersion = 1;

[[nodiscard]] std::string resultsJson(const RunReport& report);

[[nodiscard]] Expected<void> writeResultsJson(const std::filesystem::path& path, const RunReport& report);

}  // namespace ssrkit
