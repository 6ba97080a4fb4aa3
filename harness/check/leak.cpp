#include "check/leak.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "base/check.h"
#include "oracle/cell_walk.h"

namespace ssrkit {

namespace {

enum class OnPath { kYes, kNo, kTie };

OnPath onPath(const ImageRay& ray, int x, int y) {
  const int primary = std::abs(ray.px_per_sigma.x) >= std::abs(ray.px_per_sigma.y) ? 0 : 1;
  if (!ray.moves(primary)) {
    return OnPath::kYes;
  }
  const double centre_px = (primary == 0 ? x : y) + 0.5;
  const int secondary = 1 - primary;
  // A ray that ends before the middle of its last column is looked up at its end, one that starts (by the
  // origin's bias) behind the middle of its first at its origin.
  const double sigma = std::clamp(ray.sigmaAt(primary, centre_px), 0.0, ray.sigma_end);
  const double within = ray.pxAt(sigma)[secondary] - (secondary == 0 ? x : y);
  if (within > kTiePx && within < 1.0 - kTiePx) {
    return OnPath::kYes;
  }
  return within < -kTiePx || within > 1.0 + kTiePx ? OnPath::kNo : OnPath::kTie;
}

}  // namespace

LeakClassifier::LeakClassifier(const OracleInput& input)
    : input_(input), projection_(pixelProjection(*input.camera)) {
  SSRKIT_CHECK(checkInput(input).has_value());  // here and not for every turn of every ray
}

std::optional<LeakClassifier::TexelAt> LeakClassifier::firstHit(const ImageRay& ray, int x, int y) const {
  OracleInput input = input_;
  input.dist_view = &depth_without_;
  const ColumnField field = columnField(input);
  const std::vector<WalkCell> cells = walkCells(field, ray, x, y);
  if (cells.empty()) {
    return std::nullopt;
  }
  const WalkCell& last = cells.back();
  const auto [nearest_m, farthest_m] = std::minmax(last.dist_in, last.dist_out);
  const Column column = field.column(last.x, last.y);
  const bool is_hit = overlaps(column, 1.0 / farthest_m, 1.0 / nearest_m);
  return is_hit ? std::optional(TexelAt{last.x, last.y}) : std::nullopt;
}

bool LeakClassifier::isLeak(const RayHit& answer, int x, int y) {
  const PixelRay pixel = pixelRay(input_, projection_, x, y);
  if (!pixel.is_walked) {
    return false;
  }
  if (depth_without_.data.empty()) {
    depth_without_ = *input_.dist_view;
  }
  std::vector<std::pair<std::size_t, float>> removed;
  bool leak = false;
  bool done = false;
  // Each turn takes one texel away, so there are at most as many turns as the ray crosses texels.
  for (int turn = input_.dist_view->size.width + input_.dist_view->size.height; !done && turn >= 0; --turn) {
    const std::optional<TexelAt> hit = firstHit(pixel.ray, x, y);
    if (!hit) {
      leak = answer.ray_class == pixel.ray.end_class && !removed.empty();
      break;
    }
    const OnPath on_path = onPath(pixel.ray, hit->x, hit->y);
    const bool near_answer = answer.ray_class == RayClass::kHit && std::abs(hit->x - answer.texel_x) <= 1 &&
                             std::abs(hit->y - answer.texel_y) <= 1;
    leak = near_answer && on_path != OnPath::kNo && !removed.empty();
    done = leak || on_path == OnPath::kYes;
    const std::size_t index = depth_without_.index(hit->x, hit->y);
    removed.emplace_back(index, depth_without_.data[index]);
    depth_without_.data[index] = std::numeric_limits<float>::infinity();
  }
  for (const auto& [index, dist_view] : removed) {
    depth_without_.data[index] = dist_view;
  }
  return leak;
}

}  // namespace ssrkit
