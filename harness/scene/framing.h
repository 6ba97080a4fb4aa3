#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace ssrkit {

struct BoundingSphere {
  glm::dvec3 centre{0.0};
  double radius_m = 0.0;
};

// Around the centre of the scene's bounding box; the radius reaches every vertex.
[[nodiscard]] BoundingSphere boundingSphere(const Scene& scene);

// A camera that sees the whole sphere in any image at least as wide as high: from the front right, slightly
// above, 45 degrees field of view. Near and far leave room around the sphere.
[[nodiscard]] SceneCamera framedCamera(const BoundingSphere& sphere);

// A far plane beyond everything that the camera may see.
[[nodiscard]] double farBehindScene(const Scene& scene, const SceneCamera& camera);

}  // namespace ssrkit
