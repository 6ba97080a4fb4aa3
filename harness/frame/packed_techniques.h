// Techniques that trace from a packed G-buffer: what its encodings cost in hits.
#pragma once

#include <vector>

#include "frame/techniques.h"

namespace ssrkit {

[[nodiscard]] std::vector<Technique> packedTechniques();

}  // namespace ssrkit
