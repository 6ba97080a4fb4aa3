#include "environment/sky.h"

#include <algorithm>
#include <cmath>

namespace ssrkit {

glm::vec3 skyRadiance(float elevation, glm::vec3 horizon, glm::vec3 zenith) {
  const float up = std::sqrt(std::clamp(elevation, 0.0F, 1.0F));
  const float down = std::clamp(-4.0F * elevation, 0.0F, 1.0F);
  return glm::mix(glm::mix(horizon, zenith, up), 0.35F * horizon, down);
}

}  // namespace ssrkit
