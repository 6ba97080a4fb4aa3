// The reflected ray of one pixel, as the straight line that it is in the image.
#pragma once

#include <glm/glm.hpp>

#include "image/ray_record.h"
#include "oracle/oracle.h"
#include "spaces/camera.h"

namespace ssrkit {

// How far from a tie an answer must be to count as certain: the tolerances of Ambiguity.
inline constexpr double kTiePx = 5e-4;
inline constexpr double kTieRelative = 5e-6;
inline constexpr double kTieCosine = 1e-6;

// With sigma = t_m / dist_view both the pixel position and 1/dist_view are linear along a ray, for every
// direction: along the image, straight at the camera, straight away from it (where sigma ends at the finite
// value 1/dist_per_m although t_m does not).
struct ImageRay {
  glm::dvec2 px_origin{0.0};
  glm::dvec2 px_per_sigma{0.0};
  glm::dvec2 sigma_per_px{0.0};  // 1 / px_per_sigma; +inf where the ray does not move along that axis
  double inv_dist_origin = 0.0;
  double inv_dist_per_sigma = 0.0;
  double sigma_end = 0.0;
  RayClass end_class = RayClass::kOffscreen;

  [[nodiscard]] double invDistAt(double sigma) const { return inv_dist_origin + sigma * inv_dist_per_sigma; }
  [[nodiscard]] glm::dvec2 pxAt(double sigma) const { return px_origin + sigma * px_per_sigma; }
  [[nodiscard]] double tMetresAt(double sigma) const { return sigma / invDistAt(sigma); }
  [[nodiscard]] bool moves(int axis) const { return px_per_sigma[axis] != 0.0; }
  // The sigma where the coordinate `axis` is `px`. Every edge goes through this one expression, so that the
  // edge of the last texel and the edge of the image are the same number.
  [[nodiscard]] double sigmaAt(int axis, double px) const {
    return (px - px_origin[axis]) * sigma_per_px[axis];
  }
};

// What becomes of a pixel before any lookup.
struct PixelRay {
  bool is_reflected = false;  // a ray leaves the pixel: from origin_view along the unit dir_view
  glm::dvec3 origin_view{0.0};
  glm::dvec3 dir_view{0.0};
  bool is_walked = false;  // else `early_class` is the answer
  RayClass early_class = RayClass::kMasked;
  bool is_start_tie = false;  // between walking and not walking
  bool is_end_tie = false;    // between two ends of different class; nothing to a ray that hits before
  ImageRay ray;
};

// The ray of pixel (x, y), which must be inside the image. A normal of length 0 or with a NaN gives
// INTO_SURFACE, a NaN for dist_view gives BACKGROUND.
[[nodiscard]] PixelRay pixelRay(const OracleInput& input, const PixelProjection& projection, int x, int y);

}  // namespace ssrkit
