// The parts of a benchmark's text that follow the passes' tables.
#pragma once

#include <optional>
#include <string>

#include "report/bench_report.h"

namespace ssrkit {

// "1.02 .. 1.07", or "-" without an interval.
[[nodiscard]] std::string intervalText(const std::optional<RatioInterval>& interval);

// Milliseconds; "-" for 0.
[[nodiscard]] std::string msText(double ns);

// Each ends with an empty line, or is empty where there is nothing to tell.
[[nodiscard]] std::string nativesText(const BenchReport& report);
[[nodiscard]] std::string answersText(const BenchReport& report);
[[nodiscard]] std::string startsText(const BenchReport& report);
[[nodiscard]] std::string scalingText(const BenchReport& report);
[[nodiscard]] std::string changesText(const BenchReport& report);
[[nodiscard]] std::string gatesText(const BenchReport& report);

}  // namespace ssrkit
