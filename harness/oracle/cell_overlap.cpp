#include "oracle/cell_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ssrkit {

namespace {

struct Stretch {
  double sigma_in = 0.0;
  double sigma_out = -1.0;
  [[nodiscard]] bool isEmpty() const { return !(sigma_in <= sigma_out); }
};

// The part of the ray inside the footprint grown by `margin_px` on every side (negative: shrunk), and before
// the ray's end moved by the same margin.
Stretch stretchInside(const ImageRay& ray, const Column& column, double margin_px) {
  const double length_px = glm::length(ray.px_per_sigma);
  const double end_margin = margin_px == 0.0 ? 0.0 : margin_px / length_px;
  Stretch stretch{0.0, ray.sigma_end + end_margin};
  const glm::dvec2 low = glm::dvec2(column.x, column.y) - margin_px;
  const glm::dvec2 high = glm::dvec2(column.x + 1, column.y + 1) + margin_px;
  for (int axis = 0; axis < 2; ++axis) {
    if (!ray.moves(axis)) {
      if (ray.px_origin[axis] < low[axis] || ray.px_origin[axis] > high[axis]) {
        return {};
      }
      continue;
    }
    const double at_low = ray.sigmaAt(axis, low[axis]);
    const double at_high = ray.sigmaAt(axis, high[axis]);
    stretch.sigma_in = std::max(stretch.sigma_in, std::min(at_low, at_high));
    stretch.sigma_out = std::min(stretch.sigma_out, std::max(at_low, at_high));
  }
  return stretch;
}

// The contract's test with dist_view loosened (positive) or tightened (negative) by a relative tolerance.
bool overlapsWithin(const ImageRay& ray, const Column& column, const Stretch& stretch, double relative) {
  if (stretch.isEmpty() || !std::isfinite(column.near_dist)) {
    return false;
  }
  // Past the vanishing point dist_view stays infinite.
  const double at_in = std::max(ray.invDistAt(stretch.sigma_in), 0.0);
  const double at_out = std::max(ray.invDistAt(stretch.sigma_out), 0.0);
  return std::min(at_in, at_out) * column.near_dist <= 1.0 + relative &&
         std::max(at_in, at_out) * column.far_dist > 1.0 - relative;
}

}  // namespace

Overlap overlapWithTolerance(const ImageRay& ray, const Column& column) {
  Overlap overlap;
  const Stretch grown = stretchInside(ray, column, kTiePx);
  overlap.is_touched = !grown.isEmpty();
  overlap.is_possible = overlapsWithin(ray, column, grown, kTieRelative);
  overlap.is_definite =
      overlap.is_possible && overlapsWithin(ray, column, stretchInside(ray, column, -kTiePx), -kTieRelative);
  return overlap;
}

Ambiguity kindOfTie(const ImageRay& ray, const Column& column) {
  const Stretch exact = stretchInside(ray, column, 0.0);
  if (overlapsWithin(ray, column, exact, kTieRelative) != overlapsWithin(ray, column, exact, -kTieRelative)) {
    return Ambiguity::kDepth;
  }
  // With a ray that had no end, would it still be a tie?
  ImageRay endless = ray;
  endless.sigma_end = std::numeric_limits<double>::max();
  return overlapWithTolerance(endless, column).isTie() ? Ambiguity::kPosition : Ambiguity::kEnd;
}

}  // namespace ssrkit
