// The ratio of two costs from interleaved runs, with an honest account of its noise.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "check/outcome.h"

namespace ssrkit {

// The median of the per-round ratios and an interval around it.
struct RatioInterval {
  double median = 0.0;
  double low = 0.0;
  double high = 0.0;
};

// Pairs sample i with sample i, so that what slows a whole round down cancels. The interval runs between two
// order statistics of the ratios, chosen by the binomial distribution so that it holds the true median with
// at least 99 % probability, whatever the distribution of the noise. None with fewer than 8 rounds, which
// cannot give that, or when a denominator is not positive. Both spans have the same length (checked).
[[nodiscard]] std::optional<RatioInterval> pairedRatio(std::span<const double> numerators,
                                                       std::span<const double> denominators);

// pass: the whole interval holds the bound. fail: the whole interval breaks it by more than `margin`, a
// fraction of the bound. Anything else is inconclusive: the noise is larger than what there is to tell apart.
// Identical work measured twice and held to a ratio of 1 thus never fails.
[[nodiscard]] Outcome judgeRatio(const RatioInterval& ratio, std::optional<double> min,
                                 std::optional<double> max, double margin);

}  // namespace ssrkit
