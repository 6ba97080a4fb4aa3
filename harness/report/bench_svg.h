// A benchmark's figures as drawings in SVG.
#pragma once

#include <string>
#include <vector>

#include "report/bench_report.h"

namespace ssrkit {

// One for each scene, size and device: the passes' CPU time as bars from 0, with their 99 % intervals.
[[nodiscard]] std::vector<std::string> benchBars(const BenchReport& report);

// One for each axis, scene and device: every stage's time a ray over x, both logarithmic, with the fitted
// lines.
[[nodiscard]] std::vector<std::string> benchPlots(const BenchReport& report);

}  // namespace ssrkit
