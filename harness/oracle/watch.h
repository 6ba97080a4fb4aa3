// The cheap test that tells which texels of a walk are worth a close look.
#pragma once

#include <algorithm>
#include <cmath>

#include "oracle/cell_overlap.h"
#include "oracle/image_ray.h"

namespace ssrkit {

// One texel's stretch of a ray, with 1/dist_view at both ends.
struct Visit {
  double sigma_in = 0.0;
  double sigma_out = 0.0;
  double inv_dist_in = 0.0;
  double inv_dist_out = 0.0;
};

// Tolerances of one ray, constant along it: never smaller than what overlapWithTolerance grants, so that no
// tie is overlooked, and cheap enough for every texel. As constructed it grants nothing and is the contract's
// own test.
class Watch {
 public:
  Watch() = default;
  explicit Watch(const ImageRay& ray);

  [[nodiscard]] bool isWorthALook(const Column& column, const Visit& visit) const {
    const double low = std::min(visit.inv_dist_in, visit.inv_dist_out) - inv_dist_margin_;
    const double high = std::max(visit.inv_dist_in, visit.inv_dist_out) + inv_dist_margin_;
    return low * column.near_dist <= near_limit_ && high * column.far_dist > far_limit_;
  }
  // Whether a ray that crosses a vertical edge at `sigma_x` and a horizontal one at `sigma_y` passes the
  // corner between them within kTiePx.
  [[nodiscard]] bool isAtCorner(double sigma_x, double sigma_y) const {
    return std::abs(sigma_x - sigma_y) <= corner_sigma_;
  }

 private:
  double inv_dist_margin_ = 0.0;
  double near_limit_ = 1.0;
  double far_limit_ = 1.0;
  double corner_sigma_ = -1.0;
};

// The axis (0: x) along which the ray moves less.
[[nodiscard]] int minorAxis(const ImageRay& ray);

// Whether the ray drifts along an edge of the grid, or starts on one: then it misses more texels by less than
// kTiePx than those at the corners.
[[nodiscard]] bool runsAlongEdge(const ImageRay& ray);

}  // namespace ssrkit
