#include <fmt/format.h>

#include <algorithm>

#include "check/measure.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

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
