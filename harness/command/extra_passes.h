// Jobs that are drawn again to find out what their answers do not tell: whether a shader leaves its arrays,
// whether the driver cuts its loops, what the validation layer says.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "command/cell_run.h"
#include "command/worker_pool.h"
#include "conform/extra_tests.h"
#include "worker/supervisor.h"

namespace ssrkit {

// The cell beside the same job drawn with every index clamped to its array. Differences, or a crash that
// clamping prevents, mean that a shader reads or writes outside: outcome fail. Nothing where neither says
// anything: both died.
[[nodiscard]] std::optional<CheckResult> outOfBoundsCheck(const CellRun& cell, const JobOutcome& clamped);

// The cell beside the same job with loops counted, where fragments that count too many answer otherwise:
// outcome limiter where the answers differ. Nothing where the cell has no answer.
[[nodiscard]] std::optional<CheckResult> loopCheck(const CellRun& cell, const JobOutcome& counted);

// The messages of a job that was drawn under validation, each a failure; a pass where there are none.
[[nodiscard]] std::vector<CheckResult> validationChecks(const CellRun& cell, const JobOutcome& validated);

struct DeviceConcerns {
  bool is_vulkan = false;
  bool cuts_loops = false;
};

// Draws the cell's job again, in a variant (a row of frame/variants.h) and with these variables set in its
// worker.
using DrawAgain = std::function<JobOutcome(const std::string& variant, const Environment& environment)>;

// The checks of all the passes that are asked for and concern the device: validation is Vulkan's, and loops
// are counted where a driver cuts them. Their names are in `metric`. Images of a validated job are never
// compared: validation changes bits.
[[nodiscard]] std::vector<CheckResult> extraChecks(const CellRun& cell, const ExtraPasses& passes,
                                                   const DeviceConcerns& device, const DrawAgain& again);

}  // namespace ssrkit
