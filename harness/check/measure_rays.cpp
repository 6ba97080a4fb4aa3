#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "check/measure.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

// Those pairs that `disagree`.
template <class Disagree>
Measurement findingsAmong(RayPairs pairs, Disagree disagree, const Subject& subject) {
  std::vector<RayPair> differing;
  std::ranges::copy_if(pairs.pairs, std::back_inserter(differing), disagree);
  return findingsOf(std::move(pairs), std::move(differing), subject);
}

bool differ(const RayPair& pair) {
  return !sameAnswer(*pair.yours, *pair.expected);
}

double hitDistancePx(const RayPair& pair) {
  const double distance = std::hypot(static_cast<double>(pair.yours->px_x) - pair.expected->px_x,
                                     static_cast<double>(pair.yours->px_y) - pair.expected->px_y);
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

// The share of an answer's rays with one of the verdicts.
struct Share {
  double value = 0.0;
  std::size_t rays = 0;
  std::string problem;
};

Share shareOf(const Answer& answer, const std::vector<Verdict>& wanted) {
  Share share;
  share.problem = problemWithRecord(answer);
  if (share.problem.empty() && (answer.oracle == nullptr || answer.oracle_input == nullptr)) {
    share.problem = fmt::format("the oracle was not asked about the stage '{}'", answer.stage);
  }
  if (!share.problem.empty()) {
    return share;
  }
  std::size_t counted = 0;
  for (const Verdict verdict : compareWithOracle(*answer.record, *answer.oracle, *answer.oracle_input)) {
    share.rays += verdict != Verdict::kNone ? 1U : 0U;
    counted += std::ranges::find(wanted, verdict) != wanted.end() ? 1U : 0U;
  }
  share.value = static_cast<double>(counted) / std::max(1.0, static_cast<double>(share.rays));
  return share;
}

}  // namespace

Measurement measureVerdictGain(const Expectation& expectation, const Subject& subject) {
  const auto answer = answerOfTruth(subject, expectation.truth);
  if (const auto* problem = std::get_if<std::string>(&answer)) {
    return cannotMeasure(*problem);
  }
  const Share yours = shareOf(*subject.self, expectation.verdicts);
  const Share other = shareOf(*std::get<const Answer*>(answer), expectation.verdicts);
  for (const Share* share : {&yours, &other}) {
    if (!share->problem.empty()) {
      return cannotMeasure(share->problem);
    }
  }
  Measurement measurement;
  measurement.compared = std::min(yours.rays, other.rays);
  measurement.value = yours.value - other.value;
  measurement.remark =
      fmt::format("{:.4g} of the rays, {:.4g} of {}", yours.value, other.value, truthText(expectation.truth));
  return measurement;
}

Measurement measureDifferentRays(const Expectation& expectation, const Subject& subject) {
  RayPairs pairs = pairRays(subject, expectation.truth);
  if (!pairs.problem.empty()) {
    return cannotMeasure(pairs.problem);
  }
  Measurement measurement = findingsAmong(std::move(pairs), differ, subject);
  measurement.value = static_cast<double>(measurement.findings.size());
  return measurement;
}

Measurement measureAmbiguousShare(const Subject& subject) {
  const RayPairs pairs = pairRays(subject, {TruthKind::kOracle, ""});
  if (!pairs.problem.empty()) {
    return cannotMeasure(pairs.problem);
  }
  Measurement measurement;
  measurement.compared = pairs.pairs.size() + pairs.ambiguous;
  measurement.value = measurement.compared == 0
                          ? 0.0
                          : static_cast<double>(pairs.ambiguous) / static_cast<double>(measurement.compared);
  measurement.remark = fmt::format("{} of {} rays are ties", pairs.ambiguous, measurement.compared);
  return measurement;
}

Measurement measureVerdicts(const Expectation& expectation, const Subject& subject) {
  RayPairs pairs = pairRays(subject, expectation.truth);
  const Answer& self = *subject.self;
  if (!pairs.problem.empty() || self.oracle_input == nullptr) {
    return cannotMeasure(pairs.problem.empty() ? "the oracle's input is not known" : pairs.problem);
  }
  const std::vector<Verdict> verdicts = compareWithOracle(*self.record, *self.oracle, *self.oracle_input);
  const RayHit* first = self.record->rays.data();
  const auto counted = [&](const RayPair& pair) {
    const Verdict verdict = verdicts[static_cast<std::size_t>(pair.yours - first)];
    return std::ranges::find(expectation.verdicts, verdict) != expectation.verdicts.end();
  };
  Measurement measurement = findingsAmong(std::move(pairs), counted, subject);
  const VerdictCounts counts = countVerdicts(verdicts);
  std::size_t wanted = 0;
  for (const Verdict verdict : expectation.verdicts) {
    wanted += counts.at(static_cast<std::size_t>(verdict));
  }
  const std::size_t rays = verdicts.size() - counts.at(static_cast<std::size_t>(Verdict::kNone));
  measurement.compared = rays;
  const bool is_share = expectation.metric == Metric::kVerdictShare;
  const double divisor = is_share ? std::max(1.0, static_cast<double>(rays)) : 1.0;
  measurement.value = static_cast<double>(wanted) / divisor;
  std::string tally = "verdicts:";
  for (std::size_t i = 1; i < counts.size(); ++i) {
    tally += fmt::format(" {} {}", name(static_cast<Verdict>(i)), counts.at(i));
  }
  measurement.remark = tally;
  return measurement;
}

Measurement measureHitPosition(const Expectation& expectation, const Subject& subject) {
  RayPairs pairs = pairRays(subject, expectation.truth);
  if (!pairs.problem.empty()) {
    return cannotMeasure(pairs.problem);
  }
  // Another device's or case's hits may lie anywhere: what moved into another texel has moved the farthest.
  const bool moves_texels =
      expectation.truth.kind == TruthKind::kCross || expectation.truth.kind == TruthKind::kCase;
  std::erase_if(pairs.pairs, [moves_texels](const RayPair& pair) {
    return !bothHit(pair) || (!moves_texels && differ(pair));
  });
  std::vector<double> distances;
  for (const RayPair& pair : pairs.pairs) {
    distances.push_back(hitDistancePx(pair));
  }
  const double value = distances.empty() ? 0.0 : percentileOf(distances, expectation.percentile);
  // The rays at or beyond the percentile are the ones to look at.
  const RayRecord* expected = pairs.expected;
  Measurement measurement = findingsAmong(
      std::move(pairs), [&](const RayPair& pair) { return hitDistancePx(pair) >= value && value > 0.0; },
      subject);
  measurement.confusion.clear();
  measurement.cause = nullptr;
  const RayRecord* yours = subject.self->record;
  const auto position = [](const RayHit& hit) { return fmt::format("({:.4f}, {:.4f})", hit.px_x, hit.px_y); };
  for (Finding& finding : measurement.findings) {
    finding.severity = hitDistancePx(
        {finding.x, finding.y, &yours->at(finding.x, finding.y), &expected->at(finding.x, finding.y)});
  }
  measurement.describe = [=](const Finding& finding) {
    return FindingText{position(yours->at(finding.x, finding.y)),
                       position(expected->at(finding.x, finding.y)),
                       fmt::format("{:.4g} px", finding.severity)};
  };
  measurement.value = value;
  return measurement;
}

Measurement measureFoundShare(const Expectation& expectation, const Subject& subject) {
  constexpr double kFoundWithinPx = 2.0;
  const RayPairs pairs = pairRays(subject, expectation.truth);
  if (!pairs.problem.empty()) {
    return cannotMeasure(pairs.problem);
  }
  std::size_t hits = 0;
  std::size_t found = 0;
  for (const RayPair& pair : pairs.pairs) {
    hits += pair.expected->ray_class == RayClass::kHit ? 1U : 0U;
    found += bothHit(pair) && hitDistancePx(pair) <= kFoundWithinPx ? 1U : 0U;
  }
  Measurement measurement;
  measurement.compared = hits;
  measurement.compared_what = "hits";
  measurement.value = hits == 0 ? 0.0 : static_cast<double>(found) / static_cast<double>(hits);
  measurement.remark =
      fmt::format("{} of {} hits of the oracle found within {:g} px", found, hits, kFoundWithinPx);
  return measurement;
}

Measurement measureMaskFlips(const Expectation& expectation, const Subject& subject) {
  RayPairs pairs = pairRays(subject, expectation.truth);
  if (!pairs.problem.empty()) {
    return cannotMeasure(pairs.problem);
  }
  const auto flips = [](const RayPair& pair) {
    return (pair.yours->ray_class == RayClass::kHit) != (pair.expected->ray_class == RayClass::kHit);
  };
  Measurement measurement = findingsAmong(std::move(pairs), flips, subject);
  constexpr double kMillion = 1e6;
  measurement.value = kMillion * static_cast<double>(measurement.findings.size()) /
                      std::max(1.0, static_cast<double>(subject.self->record->rays.size()));
  return measurement;
}

}  // namespace ssrkit
