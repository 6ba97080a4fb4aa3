#include <fmt/format.h>

#include "check/measure.h"
#include "check/measure_image_pair.h"
#include "check/ray_bits.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

std::string bitsText(const RayHit& hit) {
  return fmt::format("{} ({}, {}) px ({:.9g}, {:.9g}) t_m {:.9g} lookups {} steps {}", name(hit.ray_class),
                     hit.texel_x, hit.texel_y, hit.px_x, hit.px_y, hit.t_m, hit.lookups, hit.steps);
}

Measurement identicalRecords(const Expectation& expectation, const Subject& subject) {
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
  const RayRecord* yours = subject.self->record;
  const RayRecord* expected = other.record;
  if (yours->size != expected->size) {
    return cannotMeasure("the records have different sizes");
  }
  Measurement measurement;
  measurement.compared_what = "pixels";
  measurement.compared = yours->rays.size();
  for (int y = 0; y < yours->size.height; ++y) {
    for (int x = 0; x < yours->size.width; ++x) {
      const RayHit& a = yours->at(x, y);
      const RayHit& b = expected->at(x, y);
      if (const auto fields = differingFields(a, b, expectation.ignore); !fields.empty()) {
        measurement.findings.push_back({x, y, static_cast<double>(fields.size())});
        ++measurement.confusion[{b.ray_class, a.ray_class}];
      }
    }
  }
  const std::vector<std::string> ignore = expectation.ignore;
  measurement.describe = [=](const Finding& finding) {
    const RayHit& a = yours->at(finding.x, finding.y);
    const RayHit& b = expected->at(finding.x, finding.y);
    return FindingText{bitsText(a), bitsText(b),
                       fmt::format("{}", fmt::join(differingFields(a, b, ignore), " "))};
  };
  return measurement;
}

Measurement identicalImages(const Expectation& expectation, const Subject& subject) {
  const ImagePair images = pairImages(expectation, subject);
  if (!images.problem.empty()) {
    return cannotMeasure(images.problem);
  }
  return measureImagePair(images, [](float a, float b) { return sameBits(a, b) ? 0.0 : 1.0; });
}

}  // namespace

Measurement measureIdentical(const Expectation& expectation, const Subject& subject) {
  Measurement measurement = expectation.buffer == "hit" ? identicalRecords(expectation, subject)
                                                        : identicalImages(expectation, subject);
  if (measurement.problem.empty()) {
    measurement.value = static_cast<double>(measurement.findings.size());
  }
  return measurement;
}

}  // namespace ssrkit
