#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "check/measure.h"
#include "check/measure_image_pair.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"
#include "image/flip.h"

namespace ssrkit {

namespace {

constexpr double kShownError = 0.1;  // findings below it are nothing to look at

// The pixels that have a ray, whose picture is the tracer's doing; every pixel where there is no record.
bool hasSay(const Answer& answer, std::size_t pixel) {
  return answer.record == nullptr || !hasNoRay(answer.record->rays.at(pixel).ray_class);
}

}  // namespace

Measurement measureFlip(const Expectation& expectation, const Subject& subject) {
  const ImagePair images = pairImages(expectation, subject);
  if (!images.problem.empty()) {
    return cannotMeasure(images.problem);
  }
  const Image map = flipMap(*images.expected, *images.yours);
  Measurement measurement;
  measurement.compared_what = "pixels";
  std::vector<double> errors;
  for (int y = 0; y < map.size.height; ++y) {
    for (int x = 0; x < map.size.width; ++x) {
      if (!hasSay(*subject.self, map.index(x, y))) {
        continue;
      }
      errors.push_back(map.at(x, y));
      if (errors.back() > kShownError) {
        measurement.findings.push_back({x, y, errors.back()});
      }
    }
  }
  measurement.compared = errors.size();
  const double count = std::max(1.0, static_cast<double>(errors.size()));
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
  const bool by_percentile = expectation.has_percentile && !errors.empty();
  measurement.value = by_percentile ? percentileOf(errors, expectation.percentile) : mean;
  measurement.remark =
      fmt::format("mean {:.4g} over {} pixels with a ray; {:.3g} % above {:g}", mean, errors.size(),
                  100.0 * static_cast<double>(measurement.findings.size()) / count, kShownError);
  measurement.describe = [](const Finding& finding) {
    return FindingText{"", "", fmt::format("{:.4g}", finding.severity)};
  };
  return measurement;
}

}  // namespace ssrkit
