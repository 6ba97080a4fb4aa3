// What holds of a march's hits whatever its steps pass by: a hit lies on its ray, inside a column that the
// step met, and no further from the true one than the step is long.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "check/march_samples.h"
#include "check/march_step.h"
#include "check/measure.h"
#include "check/ray_pairs.h"
#include "check/signatures.h"

namespace ssrkit {

namespace {

// Of fewer hits a share says little of a march.
constexpr std::size_t kFewestHits = 50;
// A texel's centre may stand for where the ray crosses it, and not the next texel's.
constexpr double kHalfTexelPx = 0.5;
// Ten times what single precision rounds off a depth along a ray; a mistake is not as small.
constexpr double kDepthSlack = 1e-4;
// Where the end of a step is tried, along the step.
constexpr double kPointsPerPx = 2.0;
constexpr double kFewestPoints = 4.0;
constexpr double kMostPoints = 64.0;

double apartPx(const RayHit& a, const RayHit& b) {
  const double distance = glm::length(hitPx(a) - hitPx(b));
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

// One stage's hits beside the oracle's.
class StepJudge {
 public:
  StepJudge(const Answer& answer, StepKind kind)
      : input_(*answer.oracle_input),
        parameters_(answer.parameters),
        kind_(kind),
        projection_(pixelProjection(*input_.camera)) {}

  // Both hit, no further apart than the step that found the hit and half a texel.
  [[nodiscard]] bool isWithinStep(const RayPair& pair) const {
    if (!bothHit(pair)) {
      return false;
    }
    const double apart_px = apartPx(*pair.yours, *pair.expected);
    if (apart_px <= kHalfTexelPx) {
      return true;
    }
    const PixelRay pixel = pixelRay(input_, projection_, pair.x, pair.y);
    const double sigma = sigmaAtMetres(pixel.ray, pair.yours->t_m);
    const double step_px =
        glm::length(pixel.ray.px_per_sigma) * (sigma - stepStart(kind_, pixel.ray, parameters_, sigma));
    return pixel.is_walked && apart_px <= step_px + kHalfTexelPx;
  }

  // A step that begins at the true hit may end where the ray is in no column: what is thinner than a step is
  // found by chance.
  [[nodiscard]] bool mayPass(const RayPair& pair) const {
    if (!isHit(*pair.expected)) {
      return false;
    }
    const ImageRay ray = pixelRay(input_, projection_, pair.x, pair.y).ray;
    const double first = sigmaAtMetres(ray, pair.expected->t_m);
    double last = stepEnd(kind_, ray, parameters_, first);
    const double end = marchEnd(kind_, ray);
    if (first >= end || (last >= end && kind_ == StepKind::kPoints)) {
      return true;  // no sample is left
    }
    last = std::min(last, end);
    const int points = pointsAlong(ray, first, last);
    const double dist_first = 1.0 / ray.invDistAt(first);
    for (int i = 1; i <= points; ++i) {
      const double sigma = first + (last - first) * i / points;
      if (!isInColumn(ray, sigma, dist_first, {pair.x, pair.y}, kDepthSlack)) {
        return true;
      }
    }
    return false;
  }

  // A hit before the true one: a step's depths are held against one column, that of its end, through which
  // the ray need not pass at those depths.
  [[nodiscard]] bool metEarly(const RayPair& pair) const {
    const RayHit& hit = *pair.yours;
    if (!isHit(hit) || kind_ == StepKind::kPoints ||
        (isHit(*pair.expected) && !(hit.t_m < pair.expected->t_m))) {
      return false;
    }
    const ImageRay ray = pixelRay(input_, projection_, pair.x, pair.y).ray;
    const double first = sigmaAtMetres(ray, hit.t_m);
    const double dist_front = 1.0 / ray.invDistAt(stepStart(kind_, ray, parameters_, first));
    const double last = std::min(stepEnd(kind_, ray, parameters_, first), marchEnd(kind_, ray));
    const int points = pointsAlong(ray, first, last);
    for (int i = 0; i <= points; ++i) {
      if (isInColumn(ray, first + (last - first) * i / points, dist_front, {pair.x, pair.y}, -kDepthSlack)) {
        return true;
      }
    }
    return false;
  }

  // The hit is where the ray is after t_m metres, and the ray's depths on the last step overlap the column of
  // its texel. Bisections only ask whether the ray is behind a surface, however far.
  [[nodiscard]] bool isOnRay(const RayPair& pair) const {
    const RayHit& hit = *pair.yours;
    const bool is_oracles = sameAnswer(hit, *pair.expected) && apartPx(hit, *pair.expected) <= kHalfTexelPx &&
                            std::abs(hit.t_m - pair.expected->t_m) <= 1e-3F * pair.expected->t_m;
    if (is_oracles) {
      return true;
    }
    const Size size = input_.dist_view->size;
    const PixelRay pixel = pixelRay(input_, projection_, pair.x, pair.y);
    if (!pixel.is_walked || hit.texel_x < 0 || hit.texel_y < 0 || hit.texel_x >= size.width ||
        hit.texel_y >= size.height) {
      return false;
    }
    const double sigma = sigmaAtMetres(pixel.ray, hit.t_m);
    const double behind = 1.0 / pixel.ray.invDistAt(sigma);
    const double front = kind_ == StepKind::kPoints
                             ? behind
                             : 1.0 / pixel.ray.invDistAt(stepStart(kind_, pixel.ray, parameters_, sigma));
    const double near_m = input_.dist_view->at(hit.texel_x, hit.texel_y);
    return glm::length(pixel.ray.pxAt(sigma) - hitPx(hit)) <= kHalfTexelPx &&
           std::max(front, behind) >= near_m * (1.0 - kDepthSlack) &&
           (parameters_.bisection_count > 0 ||
            std::min(front, behind) <= columnFar(near_m) * (1.0 + kDepthSlack));
  }

 private:
  [[nodiscard]] double columnFar(double near_m) const {
    return near_m + parameters_.thickness_m + parameters_.thickness_rel * near_m;
  }

  [[nodiscard]] static int pointsAlong(const ImageRay& ray, double first, double last) {
    const double length_px = glm::length(ray.px_per_sigma) * (last - first);
    return static_cast<int>(std::clamp(kPointsPerPx * length_px, kFewestPoints, kMostPoints));
  }

  // Whether a sample there, at the end of a step that began at dist_front, is a hit; by `slack` of the depths
  // and more.
  [[nodiscard]] bool isInColumn(const ImageRay& ray, double sigma, double dist_front, glm::ivec2 own,
                                double slack) const {
    const auto texel = glm::ivec2(glm::floor(ray.pxAt(sigma)));
    const Size size = input_.dist_view->size;
    if (texel == own || texel.x < 0 || texel.y < 0 || texel.x >= size.width || texel.y >= size.height) {
      return false;
    }
    const double dist = 1.0 / ray.invDistAt(sigma);
    const double near_m = input_.dist_view->at(texel.x, texel.y);
    const double nearest = kind_ == StepKind::kPoints ? dist : std::min(dist, dist_front);
    return dist >= near_m * (1.0 + slack) && nearest < columnFar(near_m) * (1.0 - slack);
  }

  const OracleInput& input_;
  const TraceParameters& parameters_;
  StepKind kind_;
  PixelProjection projection_;
};

struct Counted {
  std::size_t hits = 0;
  std::vector<RayPair> wrong;
};

// Of the rays that either hits, or of the answer's own hits; without ties.
Counted countHits(const Answer& answer, StepKind kind, bool of_ray) {
  const StepJudge judge(answer, kind);
  const RayRecord& yours = *answer.record;
  Counted counted;
  std::size_t index = 0;
  for (int y = 0; y < yours.size.height; ++y) {
    for (int x = 0; x < yours.size.width; ++x, ++index) {
      const RayPair pair{x, y, &yours.rays[index], &answer.oracle->record.rays[index]};
      const bool counts = isHit(*pair.yours) || (!of_ray && isHit(*pair.expected));
      if (!counts || answer.oracle->ambiguity[index] != Ambiguity::kNone) {
        continue;
      }
      const bool is_right = of_ray ? judge.isOnRay(pair) : judge.isWithinStep(pair);
      if (!is_right && !of_ray && (judge.mayPass(pair) || judge.metEarly(pair))) {
        continue;
      }
      ++counted.hits;
      if (!is_right) {
        counted.wrong.push_back(pair);
      }
    }
  }
  return counted;
}

std::string problemWith(const Answer& answer, std::optional<StepKind> kind) {
  if (std::string problem = problemWithRecord(answer); !problem.empty()) {
    return problem;
  }
  if (!kind) {
    return fmt::format("the stage '{}' does not go in steps", answer.stage);
  }
  if (answer.oracle == nullptr || answer.oracle_input == nullptr) {
    return fmt::format("the oracle was not asked about the stage '{}'", answer.stage);
  }
  const std::size_t count = answer.record->rays.size();
  const bool fits = answer.oracle->record.rays.size() == count && answer.oracle->ambiguity.size() == count;
  return fits ? "" : "the oracle's answer does not have the record's size";
}

}  // namespace

Measurement measureHitSteps(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  const std::optional<StepKind> kind = stepKind(self.stage);
  if (std::string problem = problemWith(self, kind); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const bool of_ray = expectation.metric == Metric::kHitOffRayShare;
  Counted counted = countHits(self, *kind, of_ray);
  const std::size_t wrong = counted.wrong.size();
  const std::size_t hits = counted.hits;
  // Only a failure needs all the rays, for its cause.
  const auto all_wrong = std::make_shared<const std::vector<RayPair>>(std::move(counted.wrong));
  Measurement measurement =
      findingsOf({.pairs = {}, .expected = &self.oracle->record, .problem = ""}, *all_wrong, subject);
  measurement.cause = [all_wrong, subject] {
    const RayPairs pairs = pairRays(subject, {TruthKind::kOracle, ""});
    return likelyCause({pairs.pairs, *all_wrong, *subject.self});
  };
  measurement.compared_what = "hits";
  measurement.compared = hits < kFewestHits ? 0 : hits;
  const double share = static_cast<double>(wrong) / std::max(1.0, static_cast<double>(hits));
  measurement.value = of_ray ? share : 1.0 - share;
  measurement.remark =
      of_ray
          ? fmt::format("{} of {} hits are not where their ray meets their texel's column", wrong, hits)
          : fmt::format("{} of {} rays that either hits are hit by both within a step", hits - wrong, hits);
  return measurement;
}

}  // namespace ssrkit
