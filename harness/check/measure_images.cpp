#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/size.h"
#include "check/measure.h"
#include "check/measure_image_pair.h"
#include "check/percentile.h"

namespace ssrkit {

namespace {

std::string texelText(const Image& image, int x, int y) {
  std::string text;
  for (std::size_t channel = 0; channel < image.channelCount(); ++channel) {
    text += fmt::format("{}{:.7g}", channel == 0 ? "" : " ", image.at(x, y, channel));
  }
  return text;
}

const Image* imageOf(const Answer& answer, const std::string& buffer) {
  const auto found = answer.images.find(buffer);
  return found == answer.images.end() ? nullptr : found->second;
}

// Two NaNs agree, as do two infinities of one sign; otherwise what is not finite is infinitely wrong.
double error(float yours, float expected, bool relative) {
  const double a = yours;
  const double b = expected;
  if (a == b || (std::isnan(a) && std::isnan(b))) {
    return 0.0;
  }
  const double difference = std::abs(a - b);
  const double result = relative ? difference / std::abs(b) : difference;
  return std::isfinite(a) && std::isfinite(b) && std::isfinite(result)
             ? result
             : std::numeric_limits<double>::infinity();
}

}  // namespace

ImagePair pairImages(const Expectation& expectation, const Subject& subject) {
  ImagePair pair;
  if (expectation.truth.kind == TruthKind::kGeometry) {
    pair.yours = imageOf(*subject.self, expectation.buffer);
    pair.expected = subject.self->true_dist_view;
    if (pair.yours == nullptr || pair.expected == nullptr) {
      pair.problem = fmt::format("{} of {} is not known",
                                 pair.yours == nullptr ? "dist_view" : "the geometry", subject.self->device);
    }
    return pair;
  }
  const auto answer = answerOfTruth(subject, expectation.truth);
  if (const auto* problem = std::get_if<std::string>(&answer)) {
    pair.problem = *problem;
    return pair;
  }
  const Answer& other = *std::get<const Answer*>(answer);
  pair.yours = imageOf(*subject.self, expectation.buffer);
  pair.expected = imageOf(other, expectation.buffer);
  if (pair.yours == nullptr || pair.expected == nullptr) {
    const Answer& lacking = pair.yours == nullptr ? *subject.self : other;
    pair.problem = fmt::format("{} left no buffer '{}'", lacking.device, expectation.buffer);
  } else if (pair.yours->size != pair.expected->size || pair.yours->channels != pair.expected->channels) {
    pair.problem = fmt::format("the buffers '{}' differ in size or channels: {} and {}", expectation.buffer,
                               sizeText(pair.yours->size), sizeText(pair.expected->size));
  }
  return pair;
}

Measurement measureImagePair(const ImagePair& images,
                             const std::function<double(float yours, float expected)>& texel_error) {
  const Image* yours = images.yours;
  const Image* expected = images.expected;
  Measurement measurement;
  measurement.compared_what = "pixels";
  measurement.compared = yours->texelCount();
  for (int y = 0; y < yours->size.height; ++y) {
    for (int x = 0; x < yours->size.width; ++x) {
      double worst = 0.0;
      for (std::size_t channel = 0; channel < yours->channelCount(); ++channel) {
        worst = std::max(worst, texel_error(yours->at(x, y, channel), expected->at(x, y, channel)));
      }
      if (worst > 0.0) {
        measurement.findings.push_back({x, y, worst});
      }
    }
  }
  measurement.describe = [yours, expected](const Finding& finding) {
    return FindingText{texelText(*yours, finding.x, finding.y), texelText(*expected, finding.x, finding.y),
                       fmt::format("{:.4g}", finding.severity)};
  };
  return measurement;
}

Measurement measureCoverageFlips(const Expectation& expectation, const Subject& subject) {
  const ImagePair images = pairImages(expectation, subject);
  if (!images.problem.empty()) {
    return cannotMeasure(images.problem);
  }
  Measurement measurement = measureImagePair(
      images, [](float a, float b) { return std::isfinite(a) == std::isfinite(b) ? 0.0 : 1.0; });
  measurement.value = static_cast<double>(measurement.findings.size());
  return measurement;
}

Measurement measureImageError(const Expectation& expectation, const Subject& subject) {
  const ImagePair images = pairImages(expectation, subject);
  if (!images.problem.empty()) {
    return cannotMeasure(images.problem);
  }
  const bool relative = expectation.metric == Metric::kRelativeError;
  Measurement measurement =
      measureImagePair(images, [relative](float a, float b) { return error(a, b, relative); });
  // Pixels without an error are not among the findings, but count for the percentile.
  std::vector<double> errors(measurement.compared, 0.0);
  std::ranges::transform(measurement.findings, errors.begin(), &Finding::severity);
  measurement.value = errors.empty() ? 0.0 : percentileOf(errors, expectation.percentile);
  return measurement;
}

}  // namespace ssrkit
