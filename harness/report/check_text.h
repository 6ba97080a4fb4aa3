// Short texts about one check, for lists.
#pragma once

#include <string>

#include "check/check_result.h"

namespace ssrkit {

// One line on what came out: "different_rays = 12 rays, expected <= 0 rays", or the first line of the message
// where nothing was measured, or the outcome alone. What was expected or left out is told by its reason.
[[nodiscard]] std::string summaryLine(const CheckResult& check);

}  // namespace ssrkit
