#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/geometry_verdict.h"
#include "check/measure.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

// Why the answer cannot be held against the true geometry, or nothing.
std::string problemWithGeometry(const Answer& answer) {
  if (std::string problem = problemWithRecord(answer); !problem.empty()) {
    return problem;
  }
  if (answer.geometry == nullptr || answer.oracle_input == nullptr) {
    return "what the rays truly meet is not known: there are no triangles, only the G-buffer of a renderer";
  }
  if (answer.geometry->pixelCount() != answer.record->rays.size()) {
    return "the true geometry does not have the record's size";
  }
  return {};
}

bool isAmong(TrueClass true_class, const std::vector<TrueClass>& wanted) {
  return true_class != TrueClass::kNone &&
         (wanted.empty() || std::ranges::find(wanted, true_class) != wanted.end());
}

std::string tallyOf(const GeometryCounts& counts) {
  std::string tally = "true classes:";
  for (std::size_t i = 1; i < counts.rays.size(); ++i) {
    tally += fmt::format(" {} {}", name(static_cast<TrueClass>(i)), counts.rays.at(i));
  }
  tally += "; verdicts:";
  for (std::size_t i = 1; i < kGeometryVerdictCount; ++i) {
    const auto verdict = static_cast<GeometryVerdict>(i);
    tally += fmt::format(" {} {}", name(verdict), counts.count(verdict));
  }
  return tally;
}

std::string truthText(const TrueRay& truth) {
  if (truth.true_class == TrueClass::kSky || truth.dist_view <= 0.0) {
    return name(truth.true_class);
  }
  return fmt::format("{} ({:.2f}, {:.2f}) px", name(truth.true_class), truth.plane.px.x, truth.plane.px.y);
}

void describeWithGeometry(Measurement& measurement, const Answer& self) {
  measurement.describe = [&self](const Finding& finding) {
    const RayHit& ray = self.record->at(finding.x, finding.y);
    const TrueRay& truth = self.geometry->at(finding.x, finding.y);
    const bool is_hit = ray.ray_class == RayClass::kHit;
    return FindingText{is_hit ? fmt::format("HIT ({:.2f}, {:.2f}) px, {:.5g} m", ray.px_x, ray.px_y, ray.t_m)
                              : std::string(name(ray.ray_class)),
                       fmt::format("{}, {:.5g} m", truthText(truth), truth.t_m),
                       finding.severity > 0.0 ? fmt::format("{:.4g}", finding.severity) : ""};
  };
}

double ratioOf(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / std::max(1.0, static_cast<double>(whole));
}

// How far the hit is from the true one: in pixels, or as a fraction of the true distance.
double hitError(Metric metric, const RayHit& ray, const TrueRay& truth) {
  const double error = metric == Metric::kHitPositionPx
                           ? std::hypot(ray.px_x - truth.plane.px.x, ray.px_y - truth.plane.px.y)
                           : std::abs(ray.t_m - truth.t_m) / truth.t_m;
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

}  // namespace

Measurement measureTrueClasses(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  if (std::string problem = problemWithGeometry(self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const std::vector<GeometryVerdict> verdicts =
      compareWithGeometry(*self.record, *self.geometry, *self.oracle_input);
  const GeometryCounts counts = countByTrueClass(*self.geometry, verdicts);
  Measurement measurement;
  std::size_t wanted = 0;
  for (const TrueClass true_class : expectation.true_classes) {
    wanted += counts.rays.at(static_cast<std::size_t>(true_class));
  }
  measurement.compared = counts.rayCount();
  measurement.value = ratioOf(wanted, measurement.compared);
  measurement.remark = tallyOf(counts);
  return measurement;
}

Measurement measureGeometryVerdicts(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  if (std::string problem = problemWithGeometry(self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const std::vector<GeometryVerdict> verdicts =
      compareWithGeometry(*self.record, *self.geometry, *self.oracle_input);
  Measurement measurement;
  std::size_t index = 0;
  for (int y = 0; y < self.size.height; ++y) {
    for (int x = 0; x < self.size.width; ++x, ++index) {
      if (!isAmong(self.geometry->at(index).true_class, expectation.true_classes)) {
        continue;
      }
      ++measurement.compared;
      if (std::ranges::find(expectation.geometry_verdicts, verdicts[index]) !=
          expectation.geometry_verdicts.end()) {
        measurement.findings.push_back({x, y, 0.0});
      }
    }
  }
  measurement.value = ratioOf(measurement.findings.size(), measurement.compared);
  measurement.remark = tallyOf(countByTrueClass(*self.geometry, verdicts));
  describeWithGeometry(measurement, self);
  return measurement;
}

Measurement measureTrueHitError(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  if (std::string problem = problemWithGeometry(self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  Measurement measurement;
  std::vector<double> errors;
  for (int y = 0; y < self.size.height; ++y) {
    for (int x = 0; x < self.size.width; ++x) {
      const RayHit& ray = self.record->at(x, y);
      const TrueRay& truth = self.geometry->at(x, y);
      if (truth.true_class == TrueClass::kVisible && ray.ray_class == RayClass::kHit) {
        errors.push_back(hitError(expectation.metric, ray, truth));
        measurement.findings.push_back({x, y, errors.back()});
      }
    }
  }
  measurement.compared = errors.size();
  const double value = errors.empty() ? 0.0 : percentileOf(errors, expectation.percentile);
  measurement.value = value;
  // The rays at or beyond the percentile are the ones to look at.
  std::erase_if(measurement.findings, [&](const Finding& finding) { return finding.severity < value; });
  describeWithGeometry(measurement, self);
  return measurement;
}

}  // namespace ssrkit
