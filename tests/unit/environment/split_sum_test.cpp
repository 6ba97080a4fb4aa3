// The split sum against a million points of another rule: half vectors over the whole hemisphere, no horizon
// known.
#include "environment/split_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ssrkit {
namespace {

double g1(double cosine, double alpha2) {
  return 2.0 * cosine / (cosine + std::sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine));
}

// Smith's height-correlated masking and shadowing from the two uncorrelated ones.
double g2(double cos_light, double cos_view, double alpha2) {
  const double light = g1(cos_light, alpha2);
  const double view = g1(cos_view, alpha2);
  return light * view / (light + view - light * view);
}

glm::dvec2 reference(double cos_view, double roughness) {
  constexpr int kSide = 1000;
  const double alpha = roughness * roughness;
  const double alpha2 = alpha * alpha;
  const double sin_view = std::sqrt(1.0 - cos_view * cos_view);
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kSide; ++i) {
    const double t = (i + 0.5) / kSide;
    const double tangent = alpha * t / (1.0 - t);
    const double angle = std::atan(tangent);
    const double width = alpha / ((1.0 - t) * (1.0 - t)) / (1.0 + tangent * tangent) / kSide;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const double shape = cosine * cosine * (alpha2 - 1.0) + 1.0;
    for (int j = 0; j < kSide; ++j) {
      const double azimuth = std::numbers::pi * (j + 0.5) / kSide;
      const double cos_half = sin_view * sine * std::cos(azimuth) + cos_view * cosine;
      const double cos_light = 2.0 * cos_half * cosine - cos_view;
      if (cos_half > 0.0 && cos_light > 0.0) {
        const double brdf = alpha2 / (std::numbers::pi * shape * shape) * g2(cos_light, cos_view, alpha2) /
                            (4.0 * cos_light * cos_view);
        const double solid_angle = 4.0 * cos_half * sine * width * 2.0 * std::numbers::pi / kSide;
        const double rise = std::pow(1.0 - cos_half, 5.0);
        sum += brdf * cos_light * solid_angle * glm::dvec2(1.0 - rise, rise);
      }
    }
  }
  return sum;
}

double worst(glm::dvec2 a, glm::dvec2 b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

TEST(SplitSum, IsWithinItsStatedErrorOfAMillionPoints) {
  for (const double roughness : {0.1, 0.35, 0.7, 1.0}) {
    for (const double cos_view : {0.05, 0.2, 0.5, 0.8, 1.0}) {
      const glm::dvec2 computed = splitSum(static_cast<float>(cos_view), static_cast<float>(roughness));
      EXPECT_LT(worst(computed, reference(cos_view, roughness)), 1e-3)
          << cos_view << ", roughness " << roughness;
    }
  }
}

TEST(SplitSum, OfAMirrorIsSchlicksFresnel) {
  for (int degrees = 0; degrees <= 75; degrees += 15) {
    const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
    const glm::vec2 computed = splitSum(static_cast<float>(cosine), 0.02F);
    EXPECT_NEAR(static_cast<double>(computed.y), std::pow(1.0 - cosine, 5.0), 1e-3) << degrees;
    EXPECT_NEAR(static_cast<double>(computed.x + computed.y), 1.0, 1e-3) << degrees;
  }
}

// Read as the shader reads it, between the entries.
TEST(SplitSum, TableIsWithinItsStatedErrorBetweenItsEntries) {
  const std::vector<glm::vec2> table = splitSumTable();
  const auto entry = [&](int column, int row) {
    return glm::dvec2(
        table[static_cast<std::size_t>(row) * kSplitSumSide + static_cast<std::size_t>(column)]);
  };
  double largest = 0.0;
  constexpr int kSteps = 46;  // between the entries, never on them for long
  for (int j = 0; j < kSteps; ++j) {
    for (int i = 0; i < kSteps; ++i) {
      const double roughness = 0.02 + 0.98 * j / kSteps;
      const double cos_view = 0.02 + 0.98 * i / kSteps;
      const double x = std::sqrt(cos_view) * (kSplitSumSide - 1);
      const double y = roughness * (kSplitSumSide - 1);
      const int column = static_cast<int>(x);
      const int row = static_cast<int>(y);
      const glm::dvec2 upper = glm::mix(entry(column, row), entry(column + 1, row), x - column);
      const glm::dvec2 lower = glm::mix(entry(column, row + 1), entry(column + 1, row + 1), x - column);
      const glm::dvec2 exact = splitSum(static_cast<float>(cos_view), static_cast<float>(roughness));
      largest = std::max(largest, worst(glm::mix(upper, lower, y - row), exact));
    }
  }
  EXPECT_LT(largest, 2.5e-3);
}

}  // namespace
}  // namespace ssrkit
