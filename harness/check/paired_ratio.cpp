#include "check/paired_ratio.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "base/check.h"

namespace ssrkit {

namespace {

constexpr double kConfidence = 0.99;
constexpr double kSureConfidence = 0.9999;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How many of the smallest (and as many of the largest) of `count` samples lie outside the interval; none
// when even the whole range falls short of the confidence.
std::optional<std::size_t> samplesOutside(std::size_t count, double confidence) {
  const double largest_tail = (1.0 - confidence) / 2.0;
  const auto n = static_cast<double>(count);
  // The logarithm of P(exactly k of n samples lie below the median): 0.5^n itself is 0 above 1074 samples.
  double log_term = -n * std::numbers::ln2;
  double tail = std::exp(log_term);
  if (tail > largest_tail) {
    return std::nullopt;
  }
  std::size_t outside = 0;
  while (2 * (outside + 1) < count) {
    const double k = static_cast<double>(outside + 1);
    log_term += std::log((n - k + 1.0) / k);
    tail += std::exp(log_term);
    if (tail > largest_tail) {
      break;
    }
    ++outside;
  }
  return outside;
}

// Of samples in any order; none where even their whole range falls short of the confidence.
std::optional<RatioInterval> intervalOf(std::vector<double> samples, double confidence,
                                        double sure_confidence) {
  const std::optional<std::size_t> outside = samplesOutside(samples.size(), confidence);
  if (!outside) {
    return std::nullopt;
  }
  std::ranges::sort(samples);
  const std::size_t middle = samples.size() / 2;
  const double median =
      samples.size() % 2 == 1 ? samples[middle] : (samples[middle - 1] + samples[middle]) / 2.0;
  const std::size_t last = samples.size() - 1;
  RatioInterval interval{median, samples[*outside], samples[last - *outside], -kInfinity, kInfinity};
  if (const auto sure_outside = samplesOutside(samples.size(), sure_confidence)) {
    interval.sure_low = samples[*sure_outside];
    interval.sure_high = samples[last - *sure_outside];
  }
  return interval;
}

bool areAllPositive(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return value > 0.0; });
}

}  // namespace

std::optional<RatioInterval> pairedRatio(std::span<const double> numerators,
                                         std::span<const double> denominators) {
  SSRKIT_CHECK_EQ(numerators.size(), denominators.size());
  if (!areAllPositive(denominators)) {
    return std::nullopt;
  }
  std::vector<double> ratios(numerators.size());
  std::ranges::transform(numerators, denominators, ratios.begin(), [](double a, double b) { return a / b; });
  return intervalOf(std::move(ratios), kConfidence, kSureConfidence);
}

std::optional<RatioInterval> medianInterval(std::span<const double> samples) {
  return intervalOf({samples.begin(), samples.end()}, kConfidence, kSureConfidence);
}

std::optional<RatioInterval> unpairedRatio(std::span<const double> numerators,
                                           std::span<const double> denominators) {
  // Half of the doubt for each side: both intervals hold with the confidence that is asked for.
  const auto halved = [](double confidence) { return 1.0 - (1.0 - confidence) / 2.0; };
  const auto above =
      intervalOf({numerators.begin(), numerators.end()}, halved(kConfidence), halved(kSureConfidence));
  const auto below =
      intervalOf({denominators.begin(), denominators.end()}, halved(kConfidence), halved(kSureConfidence));
  if (!above || !below || !areAllPositive(denominators)) {
    return std::nullopt;
  }
  RatioInterval ratio{above->median / below->median, above->low / below->high, above->high / below->low,
                      -kInfinity, kInfinity};
  if (std::isfinite(above->sure_low) && std::isfinite(below->sure_low)) {
    ratio.sure_low = above->sure_low / below->sure_high;
    ratio.sure_high = above->sure_high / below->sure_low;
  }
  return ratio;
}

Outcome judgeRatio(const RatioInterval& ratio, std::optional<double> min, std::optional<double> max,
                   double margin) {
  const bool breaks_max = max && ratio.sure_low > *max * (1.0 + margin);
  const bool breaks_min = min && ratio.sure_high < *min * (1.0 - margin);
  if (breaks_max || breaks_min) {
    return Outcome::kFail;
  }
  const bool holds = (!max || ratio.high <= *max) && (!min || ratio.low >= *min);
  return holds ? Outcome::kPass : Outcome::kInconclusive;
}

}  // namespace ssrkit
