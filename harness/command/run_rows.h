// The rows of a run's tables.
#pragma once

#include <vector>

#include "check/verdict.h"
#include "command/suite.h"
#include "report/run_report.h"

namespace ssrkit {

// Of one trace of the cell against Oracle A; empty where it was not asked.
[[nodiscard]] std::vector<Verdict> verdictsOf(const CellRun& cell, std::size_t trace);

// One row a trace, with the worst outcome of its checks.
[[nodiscard]] std::vector<RunRow> runRows(const SceneRun& run);

}  // namespace ssrkit
