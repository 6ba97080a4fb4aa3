// The ray of one pixel as the tracing contract defines it (docs/spaces.md): where it starts, where it heads, and the
// straight line it draws on the image.
#pragma once

#include <glm/glm.hpp>

#include "oracle/oracle.h"

namespace ssrkit {

struct RayPath {
  glm::dvec3 origin_view{0.0};  // metres, origin bias included
  glm::dvec3 dir_view{0.0};     // unit
  glm::dvec2 origin_px{0.0};
  glm::dvec2 slope_px{0.0};  // heading of the projected ray, not normalised; zero for a ray along the line of sight
  PixelProjection projection;

  [[nodiscard]] bool headsTowardCamera() const { return dir_view.z > 0.0; }
  // The larger component of the heading decides: 0 for x, 1 for y.
  [[nodiscard]] int primaryAxis() const;
  // Where the point `t_m` metres along the ray lies on the image. Only for points in front of the camera.
  [[nodiscard]] glm::dvec2 atDistance(double t_m) const;
};

// The pixel's own texel must not be background.
[[nodiscard]] RayPath rayPath(const OracleInput& input, int x, int y);

}  // namespace ssrkit
