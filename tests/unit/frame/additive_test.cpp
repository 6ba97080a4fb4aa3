// INF584's pair of buffers and its composite against their formulas.
#include <cmath>

#include "composite_image.h"
#include "white_furnace.h"

namespace ssrkit {
namespace {

class AdditiveTest : public PassTest {};

TEST_P(AdditiveTest, AdditiveGainsItsVisibilityInAFurnace) {
  give("lit", uniformImage(kFurnace, kFurnace, kFurnace, 1.0));
  giveIntegers("hit_texel",
               imageOf(
                   kCompositeSize,
                   [](int x, int y) {
                     return std::array<double, 4>{90.0 - x, 4.0 - y};
                   },
                   2),
               Format::kRg16i);
  give("visibility",
       imageOf(
           kCompositeSize, [](int, int y) { return std::array<double, 4>{shareOfRow(y)}; }, 1),
       Format::kR32f);
  EXPECT_EQ(followsFormula(
                draw("composite_additive.frag", kCompositeSize),
                [](int, int y) { return kFurnace * (1.0 + shareOfRow(y)); }, 1e-6),
            "");
}

TEST_P(AdditiveTest, AdditiveAddsTheHitsColourAndNothingOnAMiss) {
  const auto lit = [](int x, int y) { return 0.01 * x + y; };
  give("lit", imageOf(kCompositeSize, [&](int x, int y) { return std::array<double, 4>{lit(x, y)}; }));
  giveIntegers(
      "hit_texel",
      imageOf(
          kCompositeSize,
          [](int x, int y) {
            return x % 2 == 0 ? std::array<double, 4>{90.0 - x, 4.0 - y} : std::array<double, 4>{-1, -1};
          },
          2),
      Format::kRg16i);
  give("visibility",
       imageOf(
           kCompositeSize, [](int, int) { return std::array<double, 4>{0.5}; }, 1),
       Format::kR32f);
  EXPECT_EQ(
      followsFormula(
          draw("composite_additive.frag", kCompositeSize),
          [&](int x, int y) { return lit(x, y) + (x % 2 == 0 ? 0.5 * lit(90 - x, 4 - y) : 0.0); }, 1e-6),
      "");
}

TEST_P(AdditiveTest, VisibilityIsSpecularTimesItsShareByShininess) {
  const auto roughness = [](int x) { return x / 90.0; };
  giveIntegers("hit_texel",
               imageOf(
                   kCompositeSize,
                   [](int, int y) {
                     return std::array<double, 4>{y == 4 ? -1.0 : 3.0, 0};
                   },
                   2),
               Format::kRg16i);
  give("albedo", uniformImage(0.3, 0.9, 0.6, 1.0));
  give("material", imageOf(kCompositeSize, [&](int x, int y) {
         return std::array{shareOfRow(y), roughness(x), 1.0, 1.0};
       }));
  give("reflection", uniformImage(1.0, 1.0, 1.0, 0.5));
  const auto formula = [&](int x, int y) {
    const double alpha = std::pow(std::max(roughness(x), 0.15), 2);
    const double specular = 0.04 + (0.9 - 0.04) * shareOfRow(y);
    return y == 4 ? 0.0 : 0.5 * specular * (1.0 - std::exp(-(2.0 / (alpha * alpha) - 2.0) / 12.5));
  };
  EXPECT_EQ(followsFormula(draw("visibility.frag", kCompositeSize, Format::kR32f), formula, 1e-6), "");
}

INSTANTIATE_TEST_SUITE_P(Each, AdditiveTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
