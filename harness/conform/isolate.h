// Tells apart what fails always, what fails now and then, and what fails only after something else.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "check/check_result.h"
#include "conform/cell.h"

namespace ssrkit {

// Runs `before` and then `cell` on workers of their own, started for this. Gives the cell's checks.
using RunApart = std::function<std::vector<CheckResult>(const Cell& cell, std::span<const Cell> before)>;

struct Isolated {
  std::vector<CheckResult> checks;
  int extra_runs = 0;  // of the cell
};

// `checks` are those of a cell that ran in a worker after `preceding`. Where any failed, the cell is run
// again alone:
// - what fails again is a failure, as it was;
// - what passes alone twice is tried after the cells that went before it on that worker. When that brings the
//   failure back, it stays a failure, and its message names the cell that it takes (found by halving the
//   list), or says that it takes several;
// - what passes alone and cannot be brought back is a `flake`, and its message says what it was.
// The other checks of the cell stay as they were; those that a dead worker never answered are taken from the
// run alone.
[[nodiscard]] Isolated isolate(const Cell& cell, std::vector<CheckResult> checks,
                               std::span<const Cell> preceding, const RunApart& run_apart);

// The results of a cell's repeated runs, in order, as one list: a check whose outcome or value is not always
// the same is a `flake` that says so, unless it failed every time.
[[nodiscard]] std::vector<CheckResult> combineRepeats(std::span<const std::vector<CheckResult>> runs);

}  // namespace ssrkit
