#include <fmt/format.h>

#include <algorithm>

#include "check/measure.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

// Of either kind, for the mean of one to be held against the other's.
constexpr std::size_t kFewestRaysOfAKind = 100;

struct Lookups {
  std::vector<double> per_ray;
  double mean = 0.0;
};

Lookups lookupsOf(const RayRecord& record) {
  Lookups lookups;
  for (const RayHit& ray : record.rays) {
    if (!hasNoRay(ray.ray_class)) {
      lookups.per_ray.push_back(ray.lookups);
      lookups.mean += ray.lookups;
    }
  }
  lookups.mean /= std::max(1.0, static_cast<double>(lookups.per_ray.size()));
  return lookups;
}

// The rays that cost the most, for the message.
void addCostliest(const RayRecord& record, Measurement& measurement) {
  for (int y = 0; y < record.size.height; ++y) {
    for (int x = 0; x < record.size.width; ++x) {
      const double lookups = record.at(x, y).lookups;
      if (measurement.value && lookups > *measurement.value) {
        measurement.findings.push_back({x, y, lookups});
      }
    }
  }
  measurement.describe = [&record](const Finding& finding) {
    const RayHit& ray = record.at(finding.x, finding.y);
    return FindingText{fmt::format("{} lookups", ray.lookups), "", name(ray.ray_class)};
  };
}

// The mean lookups of the subject and of its truth.
struct MeanPair {
  double yours = 0.0;
  double other = 0.0;
  std::size_t compared = 0;
  std::string problem;
};

MeanPair meansOf(const Expectation& expectation, const Subject& subject) {
  MeanPair means;
  const auto answer = answerOfTruth(subject, expectation.truth);
  if (const auto* problem = std::get_if<std::string>(&answer)) {
    means.problem = *problem;
    return means;
  }
  const Answer& other = *std::get<const Answer*>(answer);
  for (const Answer* side : {subject.self, &other}) {
    means.problem = problemWithRecord(*side);
    if (!means.problem.empty()) {
      return means;
    }
  }
  const Lookups yours = lookupsOf(*subject.self->record);
  const Lookups theirs = lookupsOf(*other.record);
  means.yours = yours.mean;
  means.other = theirs.mean;
  means.compared = std::min(yours.per_ray.size(), theirs.per_ray.size());
  return means;
}

// The mean lookups of the rays that `belong`, and how many they are.
template <class Belongs>
std::pair<double, std::size_t> meanOf(const RayRecord& record, Belongs belongs) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const RayHit& ray : record.rays) {
    if (belongs(ray.ray_class)) {
      sum += ray.lookups;
      ++count;
    }
  }
  return {sum / std::max(1.0, static_cast<double>(count)), count};
}

}  // namespace

Measurement measureLookups(const Expectation& expectation, const Subject& subject) {
  if (std::string problem = problemWithRecord(*subject.self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const Lookups lookups = lookupsOf(*subject.self->record);
  Measurement measurement;
  measurement.compared = lookups.per_ray.size();
  if (lookups.per_ray.empty()) {
    measurement.value = 0.0;
    return measurement;
  }
  constexpr double kP95 = 95.0;
  constexpr double kLargest = 100.0;
  switch (expectation.metric) {
    case Metric::kP95Lookups:
      measurement.value = percentileOf(lookups.per_ray, kP95);
      break;
    case Metric::kMaxLookups:
      measurement.value = percentileOf(lookups.per_ray, kLargest);
      break;
    default:
      measurement.value = lookups.mean;
  }
  if (expectation.max) {
    addCostliest(*subject.self->record, measurement);
  }
  return measurement;
}

Measurement measureLookupRatio(const Expectation& expectation, const Subject& subject) {
  const MeanPair means = meansOf(expectation, subject);
  if (!means.problem.empty()) {
    return cannotMeasure(means.problem);
  }
  Measurement measurement;
  measurement.compared = means.compared;
  if (means.compared > 0 && means.yours == 0.0) {
    return cannotMeasure("the stage did not count a single lookup, so no ratio exists");
  }
  measurement.value = means.compared == 0 ? 0.0 : means.other / means.yours;
  measurement.remark = fmt::format("{} makes {:.4g} lookups per ray, {} {:.4g}", subject.self->stage,
                                   means.yours, expectation.truth.name, means.other);
  return measurement;
}

Measurement measureP95LookupRatio(const Expectation& expectation, const Subject& subject) {
  const auto answer = answerOfTruth(subject, expectation.truth);
  if (const auto* problem = std::get_if<std::string>(&answer)) {
    return cannotMeasure(*problem);
  }
  const Answer& other = *std::get<const Answer*>(answer);
  for (const Answer* side : {subject.self, &other}) {
    if (std::string problem = problemWithRecord(*side); !problem.empty()) {
      return cannotMeasure(std::move(problem));
    }
  }
  constexpr double kP95 = 95.0;
  const Lookups yours = lookupsOf(*subject.self->record);
  const Lookups theirs = lookupsOf(*other.record);
  const double below = theirs.per_ray.empty() ? 0.0 : percentileOf(theirs.per_ray, kP95);
  if (yours.per_ray.empty() || below == 0.0) {
    return cannotMeasure("one side did not count a single lookup, so no ratio exists");
  }
  Measurement measurement;
  measurement.compared = std::min(yours.per_ray.size(), theirs.per_ray.size());
  const double above = percentileOf(yours.per_ray, kP95);
  measurement.value = above / below;
  measurement.remark = fmt::format("95 % of the rays make at most {:g} lookups, of {} {:g}", above,
                                   expectation.truth.name, below);
  return measurement;
}

Measurement measureMissLookupRatio(const Subject& subject) {
  if (std::string problem = problemWithRecord(*subject.self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const RayRecord& record = *subject.self->record;
  const auto [hit_mean, hits] =
      meanOf(record, [](RayClass ray_class) { return ray_class == RayClass::kHit; });
  // A ray into its own surface never starts.
  const auto [miss_mean, misses] = meanOf(record, [](RayClass ray_class) {
    return !hasNoRay(ray_class) && ray_class != RayClass::kHit && ray_class != RayClass::kIntoSurface;
  });
  if (hits == 0 || misses == 0 || hit_mean == 0.0) {
    return cannotMeasure(
        fmt::format("{} rays hit and {} miss, so that no ratio of their lookups exists", hits, misses));
  }
  Measurement measurement;
  measurement.compared = hits + misses;
  if (std::min(hits, misses) < kFewestRaysOfAKind) {
    measurement.outcome = Outcome::kInconclusive;
  }
  measurement.value = miss_mean / hit_mean;
  measurement.remark = fmt::format("{} rays that miss make {:.4g} lookups each, {} that hit {:.4g}", misses,
                                   miss_mean, hits, hit_mean);
  return measurement;
}

Measurement measureLookupsAdded(const Expectation& expectation, const Subject& subject) {
  const MeanPair means = meansOf(expectation, subject);
  if (!means.problem.empty()) {
    return cannotMeasure(means.problem);
  }
  Measurement measurement;
  measurement.compared = means.compared;
  measurement.value = means.yours - means.other;
  measurement.remark =
      fmt::format("{:.4g} lookups per ray, {:.4g} at {}", means.yours, means.other, expectation.truth.name);
  return measurement;
}

}  // namespace ssrkit
