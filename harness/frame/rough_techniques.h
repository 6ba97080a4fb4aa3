// The techniques for rough surfaces: many rays a pixel, or one and its neighbours'.
#pragma once

#include <vector>

#include "frame/techniques.h"

namespace ssrkit {

[[nodiscard]] std::vector<Technique> roughTechniques();

}  // namespace ssrkit
