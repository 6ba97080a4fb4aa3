// Bands: where the picture in a mirror breaks although what it shows does not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "check/measure.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

// Neighbours whose true hits are no further apart see one surface; a mirror of the plainest kind moves the
// hit by a texel a texel.
constexpr double kContinuousPx = 2.0;
// From here on a break shows in a texture of single texels.
constexpr double kVisiblePx = 1.0;

// By how much the step from one hit to its neighbour's differs from the true one; none where either misses,
// the truth is a tie, or the true hits are apart.
struct Neighbours {
  const RayRecord* yours = nullptr;
  const RayRecord* expected = nullptr;
  const OracleResult* oracle = nullptr;

  [[nodiscard]] bool isHit(int x, int y) const {
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(yours->size.width) +
                              static_cast<std::size_t>(x);
    const bool is_tie = oracle != nullptr && oracle->ambiguity.at(pixel) != Ambiguity::kNone;
    return !is_tie && yours->at(x, y).ray_class == RayClass::kHit &&
           expected->at(x, y).ray_class == RayClass::kHit;
  }

  [[nodiscard]] std::optional<double> jumpPx(int x, int y, int other_x, int other_y) const {
    if (!isHit(x, y) || !isHit(other_x, other_y)) {
      return std::nullopt;
    }
    const glm::dvec2 truth = hitPx(expected->at(other_x, other_y)) - hitPx(expected->at(x, y));
    if (!(glm::length(truth) <= kContinuousPx)) {
      return std::nullopt;
    }
    const double jump = glm::length(hitPx(yours->at(other_x, other_y)) - hitPx(yours->at(x, y)) - truth);
    return std::isnan(jump) ? std::numeric_limits<double>::infinity() : jump;
  }
};

// The jumps from each pixel to its neighbours on the right and below.
void addJumps(const Neighbours& neighbours, std::vector<double>& jumps, std::vector<Finding>& findings) {
  const Size size = neighbours.yours->size;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      double largest = 0.0;
      for (const auto& [other_x, other_y] : {std::pair{x + 1, y}, std::pair{x, y + 1}}) {
        const bool is_inside = other_x < size.width && other_y < size.height;
        if (const auto jump = is_inside ? neighbours.jumpPx(x, y, other_x, other_y) : std::nullopt) {
          jumps.push_back(*jump);
          largest = std::max(largest, *jump);
        }
      }
      if (largest > kVisiblePx) {
        findings.push_back({x, y, largest});
      }
    }
  }
}

}  // namespace

Measurement measureHitJump(const Expectation& expectation, const Subject& subject) {
  const RayPairs pairs = pairRays(subject, expectation.truth);
  if (!pairs.problem.empty()) {
    return cannotMeasure(pairs.problem);
  }
  Measurement measurement;
  measurement.compared_what = "neighbouring rays";
  std::vector<double> jumps;
  addJumps({subject.self->record, pairs.expected, subject.self->oracle}, jumps, measurement.findings);
  const auto visible = std::ranges::count_if(jumps, [](double jump) { return jump > kVisiblePx; });
  measurement.compared = jumps.size();
  measurement.value = jumps.empty() ? 0.0 : percentileOf(jumps, expectation.percentile);
  measurement.remark = fmt::format(
      "{} of {} pairs of neighbours break by more than {:g} px ({:.3g} %)", visible, jumps.size(), kVisiblePx,
      100.0 * static_cast<double>(visible) / std::max(1.0, static_cast<double>(jumps.size())));
  measurement.describe = [yours = subject.self->record, expected = pairs.expected](const Finding& finding) {
    const auto text = [&](const RayRecord& record) {
      const glm::dvec2 px = hitPx(record.at(finding.x, finding.y));
      return fmt::format("({:.2f}, {:.2f})", px.x, px.y);
    };
    return FindingText{text(*yours), text(*expected), fmt::format("breaks by {:.4g} px", finding.severity)};
  };
  return measurement;
}

}  // namespace ssrkit
