// The machine's own limits as passes, timed beside each trace.
#pragma once

#include <vector>

#include "frame/techniques.h"

namespace ssrkit {

[[nodiscard]] std::vector<Technique> rooflineTechniques();

}  // namespace ssrkit
