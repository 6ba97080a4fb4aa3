// The ratio of two costs from interleaved runs, with an honest account of its noise.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "check/outcome.h"

namespace ssrkit {

// The median of the per-round ratios, and two intervals that hold the true median: one with at least 99 %
// probability, and one with at least 99.99 %, which is unbounded where there are fewer than the 15 rounds it
// takes.
struct RatioInterval {
  double median = 0.0;
  double low = 0.0;
  double high = 0.0;
  double sure_low = 0.0;
  double sure_high = 0.0;
};

// Pairs sample i with sample i, so that what slows a whole round down cancels. The intervals run between
// order statistics of the ratios, chosen by the binomial distribution, so that they hold whatever the
// distribution of the noise. None with fewer than 8 rounds, which cannot give 99 %, or when a denominator is
// not positive. Both spans have the same length (checked).
[[nodiscard]] std::optional<RatioInterval> pairedRatio(std::span<const double> numerators,
                                                       std::span<const double> denominators);

// The same of plain samples: their median, and the intervals that hold the true one.
[[nodiscard]] std::optional<RatioInterval> medianInterval(std::span<const double> samples);

// The ratio of two medians that were measured apart, in no common rounds. The intervals are wider than those
// of pairs: each side may lie anywhere in its own.
[[nodiscard]] std::optional<RatioInterval> unpairedRatio(std::span<const double> numerators,
                                                         std::span<const double> denominators);

// pass: the whole 99 % interval holds the bound. fail: the whole 99.99 % interval breaks it by more than
// `margin`, a fraction of the bound; to accuse takes more certainty than to acquit, so that identical work
// measured twice and held to a ratio of 1 does not fail. Anything else is inconclusive: the noise is larger
// than what there is to tell apart.
[[nodiscard]] Outcome judgeRatio(const RatioInterval& ratio, std::optional<double> min,
                                 std::optional<double> max, double margin);

}  // namespace ssrkit
