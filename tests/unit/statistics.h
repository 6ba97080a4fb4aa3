// What the statistical tests judge by. Every test of a family is held to the family's level divided by its
// size (Bonferroni), so that the whole family rejects a right shader as rarely as the level says.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace ssrkit {

constexpr double kFamilyLevel = 1e-3;

// Probability that a standard normal number is beyond z on either side.
inline double twoSidedP(double z) {
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

// Probability of a chi-squared number above `value`: its cube root is nearly normal (Wilson and Hilferty,
// "The Distribution of Chi-Square", PNAS 17(12) 1931; within 1e-4 of the exact one from 30 degrees of
// freedom).
inline double chiSquaredP(double value, double degrees) {
  const double spread = 2.0 / (9.0 * degrees);
  const double z = (std::cbrt(value / degrees) - (1.0 - spread)) / std::sqrt(spread);
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

// Pearson's test of counts against probabilities. Cells that expect fewer than ten are taken together.
inline double pearsonP(std::span<const double> counts, std::span<const double> probabilities) {
  double total = 0.0;
  for (const double count : counts) {
    total += count;
  }
  double value = 0.0;
  double degrees = -1.0;
  double rest_count = 0.0;
  double rest_expected = 0.0;
  const auto addCell = [&](double count, double expected) {
    value += (count - expected) * (count - expected) / expected;
    degrees += 1.0;
  };
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    const double expected = total * probabilities[cell];
    if (expected >= 10.0) {
      addCell(counts[cell], expected);
    } else {
      rest_count += counts[cell];
      rest_expected += expected;
    }
  }
  if (rest_expected >= 1.0 || rest_count > 0.0) {
    addCell(rest_count, std::max(rest_expected, 1e-9));
  }
  return chiSquaredP(value, degrees);
}

// Slope of the least-squares line.
inline double slopeOf(std::span<const double> x, std::span<const double> y) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / static_cast<double>(x.size());
    mean_y += y[i] / static_cast<double>(x.size());
  }
  double above = 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    above += (x[i] - mean_x) * (y[i] - mean_y);
    below += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return above / below;
}

}  // namespace ssrkit
