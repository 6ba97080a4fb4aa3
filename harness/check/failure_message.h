// What a check that does not hold says: where, yours, expected, how widespread, the likely cause, how to run
// it again.
#pragma once

#include <string>

#include "check/check_result.h"
#include "check/expectation.h"
#include "check/measurement.h"

namespace ssrkit {

// Several lines without a final newline. `result` is filled but for its message.
[[nodiscard]] std::string failureMessage(const CheckResult& result, const Expectation& expectation,
                                         Measurement measurement);

}  // namespace ssrkit
