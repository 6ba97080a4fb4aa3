// Whether a ray meets a texel's column, and how surely.
#pragma once

#include <algorithm>

#include "oracle/image_ray.h"

namespace ssrkit {

// One texel's column over its footprint: from dist_view `near_dist` to `far_dist`, in metres.
struct Column {
  int x = 0;
  int y = 0;
  double near_dist = 0.0;
  double far_dist = 0.0;
};

// The contract's test over the stretch of the ray between these two values of 1/dist_view: the largest
// dist_view reaches the column's front and the smallest is in front of its back. Written with products, so
// that a background of +inf, a thickness of +inf and a NaN need no case of their own. At a vanishing point
// 1/dist_view may have been rounded below 0.
[[nodiscard]] inline bool overlaps(const Column& column, double inv_dist_in, double inv_dist_out) {
  const double low = std::max(std::min(inv_dist_in, inv_dist_out), 0.0);
  const double high = std::max(inv_dist_in, inv_dist_out);
  return low * column.near_dist <= 1.0 && high * column.far_dist > 1.0;
}

struct Overlap {
  bool is_touched = false;   // the ray comes within kTiePx of the footprint
  bool is_possible = false;  // a hit when every tolerance is granted
  bool is_definite = false;  // a hit when every tolerance is taken away
  [[nodiscard]] bool isTie() const { return is_possible && !is_definite; }
};

[[nodiscard]] Overlap overlapWithTolerance(const ImageRay& ray, const Column& column);

// Which of the tolerances makes the tie.
[[nodiscard]] Ambiguity kindOfTie(const ImageRay& ray, const Column& column);

}  // namespace ssrkit
