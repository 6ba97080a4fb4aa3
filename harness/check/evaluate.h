#pragma once

#include "check/check_result.h"
#include "check/expectation.h"
#include "check/subject.h"

namespace ssrkit {

// Holds one answer to one expectation. A truth that is not there is an error, never a pass. Where nothing
// could be compared the check fails, unless the expectation allows it.
[[nodiscard]] CheckResult evaluate(const Expectation& expectation, const Subject& subject);

}  // namespace ssrkit
