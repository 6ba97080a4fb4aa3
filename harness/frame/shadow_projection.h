// Where the shadow map of a directional light looks: an orthographic view of the scene in cascades, each
// fitted to a slice of the camera's frustum and to the scene, whichever is tighter.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"
#include "spaces/camera.h"

namespace ssrkit {

inline constexpr int kShadowMaxCascades = 4;    // as in shaders/include/shadow_map.glsl
inline constexpr int kShadowSideTexels = 1536;  // of one cascade; they lie side by side in one image
inline constexpr int kShadowMarginTexels = 2;   // on each side: what the filter reads beyond a point

struct WorldBounds {
  glm::dvec3 least{0.0};
  glm::dvec3 greatest{0.0};
};

// Of all vertices; a point at the origin without any.
[[nodiscard]] WorldBounds worldBounds(const Scene& scene);

struct ShadowCascade {
  glm::dvec2 origin_m{0.0};  // light-space x, y of the map's first corner, a whole number of texels
  double texel_m = 1.0;
};

// Light space: metres, z along the light's way, x and y along the map's columns and rows, the world's origin.
struct ShadowProjection {
  glm::dmat4 light_from_world{1.0};
  double near_m = 0.0;                  // light-space z of the map's depth 0
  double range_m = 1.0;                 // from there to depth 1
  std::vector<ShadowCascade> cascades;  // one to kShadowMaxCascades, the nearest slice first
};

// The last slice ends where the scene does, and each before it at an eighth of that, until one ends within
// eight metres: distances of equal ratio keep the texel's size on the image about the same in each (Zhang et
// al., "Parallel-Split Shadow Maps for Large-scale Virtual Environments", VRCIA 2006, the logarithmic
// scheme).
//
// Each cascade covers its slice's bounding sphere, or the scene along an axis where that is smaller. Both
// sizes are the same wherever the camera is, and the corner is a whole number of texels, so a camera that
// moves or turns never makes an edge crawl (Valient, "Stable Rendering of Cascaded Shadow Maps", ShaderX6,
// 2008).
[[nodiscard]] ShadowProjection fitShadow(const glm::dvec3& direction_world, const WorldBounds& scene,
                                         const Camera& camera);

}  // namespace ssrkit
