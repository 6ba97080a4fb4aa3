// Which of the standard checks (tests/expect/standard.toml) a run asks of a scene.
#pragma once

#include "check/expectation.h"
#include "command/run.h"
#include "command/suite.h"

namespace ssrkit {

// Leaves out what is not asked of the chosen stages, what the parameters make untrue of a right tracer
// (strides and jitter let the DDA pass more than it leaks, a budget ends the pyramid's tracer later than the
// walk, and of other steps than its own nobody knows what a march passes by), and closed forms where the
// scene is not one that has a formula, as its first camera sees it.
void keepWhatIsAsked(TestFile& test, const SceneSource& source, const RunOptions& options);

}  // namespace ssrkit
