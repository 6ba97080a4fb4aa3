#include "spaces/camera.h"

#include <fmt/format.h>

#include <cmath>

namespace ssrkit {

namespace {

bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) {
        return false;
      }
    }
  }
  return true;
}

// A perspective matrix has clip.w = -p_view.z and leaves x and y apart but for an off-centre shift.
bool isPerspective(const glm::dmat4& p) {
  return p[0][3] == 0.0 && p[1][3] == 0.0 && p[2][3] == -1.0 && p[3][3] == 0.0 && p[0][1] == 0.0 &&
         p[1][0] == 0.0 && p[3][0] == 0.0 && p[3][1] == 0.0 && p[0][2] == 0.0 && p[1][2] == 0.0;
}

bool isAffine(const glm::dmat4& matrix) {
  constexpr double kTolerance = 1e-6;
  return std::abs(matrix[0][3]) <= kTolerance && std::abs(matrix[1][3]) <= kTolerance &&
         std::abs(matrix[2][3]) <= kTolerance && std::abs(matrix[3][3] - 1.0) <= kTolerance;
}

bool isRigid(const glm::dmat4& matrix) {
  constexpr double kTolerance = 1e-3;
  const glm::dmat3 turn(matrix);
  const glm::dmat3 off = glm::transpose(turn) * turn - glm::dmat3(1.0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!(std::abs(off[column][row]) <= kTolerance)) {
        return false;
      }
    }
  }
  return isAffine(matrix);
}

}  // namespace

PixelProjection pixelProjection(const Camera& camera) {
  const glm::dmat4& p = camera.clip_from_view;
  const glm::dvec2 half_size(0.5 * camera.size.width, 0.5 * camera.size.height);
  // NDC x = P00 (x / dist) - P02, and y likewise; p_px.y grows downwards.
  return {.px_scale = {half_size.x * p[0][0], -half_size.y * p[1][1]},
          .px_offset = {half_size.x * (1.0 - p[2][0]), half_size.y * (1.0 + p[2][1])}};
}

glm::dmat4 perspective(double fov_y_rad, double aspect, double near_m, double far_m) {
  const double focal = 1.0 / std::tan(0.5 * fov_y_rad);
  glm::dmat4 p(0.0);
  p[0][0] = focal / aspect;
  p[1][1] = focal;
  p[2][2] = far_m / (near_m - far_m);
  p[2][3] = -1.0;
  p[3][2] = near_m * far_m / (near_m - far_m);
  return p;
}

Expected<void> validate(const Camera& camera, const std::string& attempted) {
  const auto [width, height] = camera.size;
  if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide) {
    return inputError(attempted, fmt::format("the size {}x{} is outside 1x1 to {}x{}", width, height,
                                             kMaxImageSide, kMaxImageSide));
  }
  if (!isFinite(camera.clip_from_view) || !isFinite(camera.view_from_world) ||
      !isFinite(camera.previous_view_from_world.value_or(glm::dmat4(1.0)))) {
    return inputError(attempted, "a matrix of the camera holds a number that is not finite");
  }
  if (!isPerspective(camera.clip_from_view)) {
    return inputError(attempted, "clip_from_view is not a perspective projection with clip.w = -z", "",
                      "orthographic cameras are not supported, use a perspective one");
  }
  const glm::dmat4& p = camera.clip_from_view;
  if (p[0][0] == 0.0 || p[1][1] == 0.0 || p[3][2] == 0.0) {
    return inputError(attempted, "clip_from_view is singular", "",
                      "row 0, column 0; row 1, column 1; and row 2, column 3 must not be 0");
  }
  if (glm::determinant(glm::dmat3(camera.view_from_world)) == 0.0) {
    return inputError(attempted, "view_from_world is singular", "",
                      "its upper left 3x3 part must be a rotation");
  }
  if (!(camera.near_m > 0.0) || !std::isfinite(camera.near_m) || !(camera.far_m > camera.near_m)) {
    return inputError(attempted, fmt::format("near_m = {} and far_m = {} must satisfy 0 < near_m < far_m",
                                             camera.near_m, camera.far_m));
  }
  return {};
}

Expected<void> validateRigid(const Camera& camera, const std::string& attempted) {
  const auto check = [&](const char* name, const glm::dmat4& matrix) -> Expected<void> {
    if (isRigid(matrix)) {
      return {};
    }
    return inputError(attempted, fmt::format("{} is not a rotation with a shift", name), "",
                      isAffine(matrix)
                          ? "its first three columns must be of length 1 and at right angles: the "
                            "camera has no scale"
                          : "its last row must be 0 0 0 1");
  };
  const auto now = check("view_from_world", camera.view_from_world);
  return now && camera.previous_view_from_world
             ? check("previous_view_from_world", *camera.previous_view_from_world)
             : now;
}

double depthWindowFromDistView(const Camera& camera, double dist_view) {
  // depth = (P22 z + P32) / -z with z = -dist.
  const glm::dmat4& p = camera.clip_from_view;
  return p[3][2] / dist_view - p[2][2];
}

}  // namespace ssrkit
