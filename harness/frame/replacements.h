// Shaders of the user's own in the place of a pass's.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "frame/job.h"
#include "frame/programs.h"

namespace ssrkit {

// How the job's passes are compiled. A replacement names a pass, or a stage for its trace shaders. Fails on
// variants and names that no pass has.
[[nodiscard]] Expected<CompileSettings> compileSettings(const Job& job);

// Fails on a replacement that takes no place among the passes that were drawn: its author would be left with
// the kit's own results.
[[nodiscard]] Expected<void> checkReplacementsTookPlace(const std::vector<ShaderReplacement>& replacements,
                                                        const std::set<std::string>& drawn_passes);

}  // namespace ssrkit
