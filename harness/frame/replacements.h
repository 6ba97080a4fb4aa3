// Shaders of the user's own in the place of a pass's.
#pragma once

#include "base/error.h"
#include "frame/job.h"
#include "frame/programs.h"

namespace ssrkit {

// How the job's passes are compiled. A replacement names a pass, or a stage for its trace shaders. Fails on
// variants and names that no pass has, and on a trace pass that the job does not draw.
[[nodiscard]] Expected<CompileSettings> compileSettings(const Job& job);

}  // namespace ssrkit
