#include "check/paired_ratio.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
  double term = std::pow(0.5, static_cast<double>(count));  // P(exactly k of n samples lie below the median)
  double tail = term;
  if (tail > largest_tail) {
    return std::nullopt;
  }
  std::size_t outside = 0;
  while (2 * (outside + 1) < count) {
    const double k = static_cast<double>(outside + 1);
    term *= (static_cast<double>(count) - k + 1.0) / k;
    if (tail + term > largest_tail) {
      break;
    }
    tail += term;
    ++outside;
  }
  return outside;
}

}  // namespace

std::optional<RatioInterval> pairedRatio(std::span<const double> numerators,
                                         std::span<const double> denominators) {
  SSRKIT_CHECK_EQ(numerators.size(), denominators.size());
  const std::optional<std::size_t> outside = samplesOutside(numerators.size(), kConfidence);
  if (!outside || std::ranges::any_of(denominators, [](double value) { return !(value > 0.0); })) {
    return std::nullopt;
  }
  std::vector<double> ratios(numerators.size());
  std::ranges::transform(numerators, denominators, ratios.begin(), [](double a, double b) { return a / b; });
  std::ranges::sort(ratios);
  const std::size_t middle = ratios.size() / 2;
  const double median = ratios.size() % 2 == 1 ? ratios[middle] : (ratios[middle - 1] + ratios[middle]) / 2.0;
  const std::size_t last = ratios.size() - 1;
  RatioInterval interval{median, ratios[*outside], ratios[last - *outside], -kInfinity, kInfinity};
  if (const auto sure_outside = samplesOutside(ratios.size(), kSureConfidence)) {
    interval.sure_low = ratios[*sure_outside];
    interval.sure_high = ratios[last - *sure_outside];
  }
  return interval;
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
