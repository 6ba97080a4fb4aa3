// The table of what each pass of a frame costs.
#pragma once

#include <span>
#include <string>

#include "report/run_report.h"

namespace ssrkit {

// For each trace (scene, size, stage, case): every pass of the frame and of the trace in the order in which
// they are drawn, and their sum; for each device the CPU time and how many times the pass "trace" that is.
// Medians over the rounds. Ends with a line feed; empty without timed rows.
[[nodiscard]] std::string passTable(std::span<const FrameRow> frames, std::span<const RunRow> rows);

}  // namespace ssrkit
