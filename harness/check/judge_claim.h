// What a claim's figures say of it.
#pragma once

#include <span>
#include <vector>

#include "check/check_result.h"
#include "check/claim.h"

namespace ssrkit {

struct ClaimFigure {
  CheckResult check;
  RefutingBounds refuting;
  bool decides = true;  // false: shown for its own sake
  ClaimVerdict verdict = ClaimVerdict::kNotMeasured;
};

struct ClaimResult {
  ClaimVerdict verdict = ClaimVerdict::kNotMeasured;
  std::vector<ClaimFigure> figures;
};

// By the checks of all scenes, sizes and devices that the claim's test was run on. A claim is said of all of
// them: one figure that refutes it is enough, and all that decide must confirm it. A measured ratio of times
// decides by its whole 99 % interval. Checks that are none of the test's expectations (a worker that died)
// tell that nothing is known.
[[nodiscard]] ClaimResult judgeClaim(const Claim& claim, std::span<const CheckResult> checks);

}  // namespace ssrkit
