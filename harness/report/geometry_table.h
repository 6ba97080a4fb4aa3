// "What screen space can and cannot know", as tables.
#pragma once

#include <span>
#include <string>

#include "report/run_report.h"

namespace ssrkit {

// A line a scene: what its rays truly meet, and how far the exact walk of the depth image gets, in percent of
// the rays. At most 100 columns; empty without rows.
[[nodiscard]] std::string geometryTable(std::span<const GeometryRow> rows);

// For each trace that was held against the geometry, its verdicts against Oracle A by what the rays truly
// meet, in rays. At most 100 columns; empty without such traces.
[[nodiscard]] std::string trueClassTable(std::span<const RunRow> rows);

}  // namespace ssrkit
