// The walk from texel to texel along one ray.
#pragma once

#include <vector>

#include "oracle/cell_overlap.h"
#include "oracle/image_ray.h"
#include "oracle/oracle.h"

namespace ssrkit {

// The depth image as the contract's columns.
struct ColumnField {
  const float* dist_view = nullptr;
  Size size;
  double far_scale = 1.0;  // far_dist = far_scale * near_dist + thickness_m
  double thickness_m = 0.0;
  std::uint32_t lookup_budget = 0;

  [[nodiscard]] bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < size.width && y < size.height;
  }
  [[nodiscard]] std::ptrdiff_t indexOf(int x, int y) const {
    return static_cast<std::ptrdiff_t>(y) * size.width + x;
  }
  [[nodiscard]] double farDist(double near_dist) const { return far_scale * near_dist + thickness_m; }
  [[nodiscard]] Column column(int x, int y) const {
    const double near_dist = dist_view[indexOf(x, y)];
    return {.x = x, .y = y, .near_dist = near_dist, .far_dist = farDist(near_dist)};
  }
};

[[nodiscard]] ColumnField columnField(const OracleInput& input);

// The texel that the walk stands in, and where the ray leaves it along either axis. An exact pass through a
// corner steps along x first.
struct CellStep {
  int x = 0;
  int y = 0;
  int dx = 1;
  int dy = 1;
  double sigma_x =
      0.0;  // the ray crosses the texel's next vertical edge here, its next horizontal one at sigma_y
  double sigma_y = 0.0;

  explicit CellStep(const ImageRay& ray);
  [[nodiscard]] bool leavesAlongX() const { return sigma_x <= sigma_y; }
  [[nodiscard]] double sigmaOut() const { return leavesAlongX() ? sigma_x : sigma_y; }
  void step(const ImageRay& ray) {
    if (leavesAlongX()) {
      x += dx;
      sigma_x = ray.sigmaAt(0, x + (dx > 0 ? 1 : 0));
    } else {
      y += dy;
      sigma_y = ray.sigmaAt(1, y + (dy > 0 ? 1 : 0));
    }
  }
};

struct WalkResult {
  RayHit hit;
  Ambiguity ambiguity = Ambiguity::kNone;
};

// Walks the ray of pixel (own_x, own_y).
[[nodiscard]] WalkResult walkRay(const ColumnField& field, const ImageRay& ray, int own_x, int own_y);

// The cells of the same walk, in order, the hit last; without ambiguities and for one ray at a time.
[[nodiscard]] std::vector<WalkCell> walkCells(const ColumnField& field, const ImageRay& ray, int own_x,
                                              int own_y);

}  // namespace ssrkit
