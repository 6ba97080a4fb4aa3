#pragma once

#include <vector>

#include "frame/techniques.h"

namespace ssrkit {

// Techniques that read the previous frame.
[[nodiscard]] std::vector<Technique> temporalTechniques();

}  // namespace ssrkit
