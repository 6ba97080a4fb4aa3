// Cameras and the spaces of docs/spaces.md, in double precision. shaders/include/ssr_spaces.glsl says the
// same for GLSL; tests/unit/spaces keeps the two equal.
//
// view space: +x right, +y up, the camera looks along -z. NDC: +x right, +y up, z 0 at the near plane and 1
// at the far plane. Pixel position p_px: origin upper left, +y down, texel centres at .5.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/error.h"
#include "base/size.h"

namespace ssrkit {

struct Camera {
  Size size;
  glm::dmat4 clip_from_view{1.0};   // perspective: clip.w = dist_view
  glm::dmat4 view_from_world{1.0};  // rigid, but for views mirrored or scaled on purpose
  std::optional<glm::dmat4> previous_view_from_world = {};  // in the previous frame; absent: as now
  double near_m = 0.1;
  double far_m = 1000.0;
};

// The projection between view positions and pixel positions, for perspective matrices (also off-centre ones):
//   p_px = px_scale * (p_view.xy / dist_view) + px_offset,   p_view.xy = dist_view * (p_px - px_offset) /
//   px_scale
struct PixelProjection {
  glm::dvec2 px_scale;
  glm::dvec2 px_offset;
};

[[nodiscard]] PixelProjection pixelProjection(const Camera& camera);

// clip_from_view of a symmetric perspective camera, NDC z in 0..1, +y up.
[[nodiscard]] glm::dmat4 perspective(double fov_y_rad, double aspect, double near_m, double far_m);

// Refuses what no tracer can use: size outside 1..16384, non-finite numbers, an orthographic or singular
// projection, a singular view_from_world, near_m <= 0, far_m <= near_m. `attempted` starts the error's
// sentence.
[[nodiscard]] Expected<void> validate(const Camera& camera, const std::string& attempted);

// Refuses a view_from_world, now or in the previous frame, that changes lengths or angles by more than a
// thousandth: other programs write 32-bit numbers, and few of their digits. A mirrored one is the view of a
// left-handed world.
[[nodiscard]] Expected<void> validateRigid(const Camera& camera, const std::string& attempted);

// The stored depth (0..1) of a dist_view.
[[nodiscard]] double depthWindowFromDistView(const Camera& camera, double dist_view);

}  // namespace ssrkit
