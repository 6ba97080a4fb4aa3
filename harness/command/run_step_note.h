// What is to be said of a trace whose step_m is too short for its rays.
#pragma once

#include <optional>
#include <string>

#include "frame/job.h"

namespace ssrkit {

// One sentence where rays took as many steps as there are, so that some of them may have taken longer ones
// than step_m; nothing otherwise. What such a ray hit before its end is not counted.
[[nodiscard]] std::optional<std::string> shortStepNote(const TraceResult& trace);

}  // namespace ssrkit
