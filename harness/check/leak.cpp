#include "check/leak.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "check/ray_path.h"

namespace ssrkit {

namespace {

constexpr double kTiePx = 2e-3;  // the oracle's own measure of a tie in position

enum class OnPath { kYes, kNo, kTie };

OnPath onPath(const RayPath& path, int x, int y) {
  const int primary = path.primaryAxis();
  const int secondary = 1 - primary;
  if (path.slope_px[primary] == 0.0) {
    return OnPath::kYes;
  }
  const double centre = (primary == 0 ? x : y) + 0.5;
  const double along = (centre - path.origin_px[primary]) / path.slope_px[primary];
  const double within = path.origin_px[secondary] + along * path.slope_px[secondary] - (secondary == 0 ? x : y);
  if (within > kTiePx && within < 1.0 - kTiePx) {
    return OnPath::kYes;
  }
  return within < -kTiePx || within > 1.0 + kTiePx ? OnPath::kNo : OnPath::kTie;
}

}  // namespace

LeakClassifier::LeakClassifier(const OracleInput& input) : depth_without_(*input.dist_view), input_(input) {}

std::optional<LeakClassifier::TexelAt> LeakClassifier::firstHit(int x, int y) const {
  OracleInput input = input_;
  input.dist_view = &depth_without_;
  const std::vector<WalkCell> cells = cellsOf(input, x, y);
  if (cells.empty()) {
    return std::nullopt;
  }
  const WalkCell& last = cells.back();
  const double near_m = static_cast<double>(depth_without_.at(last.x, last.y));
  if (!std::isfinite(near_m)) {
    return std::nullopt;
  }
  const double thickness_m = input.parameters.thickness_m + input.parameters.thickness_rel * near_m;
  const auto [nearest_m, farthest_m] = std::minmax(last.dist_in, last.dist_out);
  const bool overlaps = farthest_m >= near_m && nearest_m < near_m + thickness_m;
  return overlaps ? std::optional(TexelAt{last.x, last.y}) : std::nullopt;
}

bool LeakClassifier::isLeak(const RayHit& answer, int x, int y) {
  const RayPath path = rayPath(input_, x, y);
  const bool answer_is_hit = answer.ray_class == RayClass::kHit;
  const bool answer_is_end =
      answer.ray_class == RayClass::kOffscreen || answer.ray_class == RayClass::kRange;
  std::vector<std::pair<std::size_t, float>> removed;
  bool leak = false;
  bool done = !answer_is_hit && !answer_is_end;
  // Each turn takes one texel away, so there are at most as many turns as the ray has texels.
  for (int turn = input_.dist_view->size.width + input_.dist_view->size.height; !done && turn >= 0; --turn) {
    const std::optional<TexelAt> hit = firstHit(x, y);
    if (!hit) {
      leak = answer_is_end && !removed.empty();
      break;
    }
    const OnPath on_path = onPath(path, hit->x, hit->y);
    const bool near_answer = answer_is_hit && std::abs(hit->x - answer.texel_x) <= 1 &&
                             std::abs(hit->y - answer.texel_y) <= 1;
    leak = near_answer && !removed.empty();
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
