// The gradient sky, the C++ of shaders/include/sky.glsl; a test keeps them equal.
#pragma once

#include <glm/glm.hpp>

namespace ssrkit {

// Radiance from a direction whose elevation above the horizon has this sine.
[[nodiscard]] glm::vec3 skyRadiance(float elevation, glm::vec3 horizon, glm::vec3 zenith);

}  // namespace ssrkit
