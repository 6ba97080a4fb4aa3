#pragma once

#include "check/check_result.h"

namespace ssrkit {

// A check that did not pass, with everything that its reader needs: what, where, why, and how to run it
// again.
void printCheck(const CheckResult& check);

}  // namespace ssrkit
