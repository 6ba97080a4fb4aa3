// What the filter of stochastic SSR takes away, and what it leaves.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pass_test.h"

namespace ssrkit {
namespace {

class RoughFilterTest : public PassTest {
 protected:
  static constexpr Size kSize{48, 48};

  // A plane that faces the eye 4 m away, of one roughness.
  void SetUp() override {
    PassTest::SetUp();
    begin();
    values_.set("size_px", glm::dvec2(48.0));
    values_.set("texel_uv", glm::dvec2(1.0 / 48.0));
    values_.set("px_offset", glm::dvec2(24.0));
    values_.set("view_per_px", glm::dvec2(1.0 / 48.0, -1.0 / 48.0));
    values_.set("spacing_px", 1);
    surface([](int) { return Surface{}; });
  }

  struct Surface {
    double dist = 4.0;
    glm::dvec3 normal{0.0, 0.0, 1.0};
    double roughness = 0.25;
    double mask = 1.0;
  };
  void surface(const std::function<Surface(int x)>& at) {
    give("dist_view", imageOf(
                          kSize,
                          [&](int x, int) {
                            return std::array{at(x).dist, 0.0, 0.0, 0.0};
                          },
                          1));
    give("normal_view", imageOf(kSize, [&](int x, int) {
           return std::array{at(x).normal.x, at(x).normal.y, at(x).normal.z, 1.0};
         }));
    give("material", imageOf(kSize, [&](int x, int) {
           return std::array{1.0, at(x).roughness, at(x).mask, 0.0};
         }));
  }
  void radiance(const std::function<double(int x)>& at, double variance) {
    give("unfiltered", imageOf(kSize, [&](int x, int) { return std::array{at(x), at(x), at(x), 1.0}; }));
    give("unfiltered_variance", imageOf(
                                    kSize,
                                    [&](int, int) {
                                      return std::array{variance, 0.0, 0.0, 0.0};
                                    },
                                    1));
  }
};

TEST_P(RoughFilterTest, AConstantKeepsItsBits) {
  radiance([](int) { return 0.3; }, 0.01);
  const Image filtered = draw("filter_reflection.frag", kSize);
  for (const float value : std::vector(filtered.data.begin(), filtered.data.begin() + 3)) {
    EXPECT_EQ(value, 0.3F);
  }
  EXPECT_EQ(difference(filtered,
                       imageOf(kSize,
                               [](int, int) {
                                 return std::array{0.3, 0.3, 0.3, 1.0};
                               }),
                       0.0),
            "");
}

TEST_P(RoughFilterTest, NoiseOfItsOwnVarianceIsAveraged) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.5, 0.1);
  give("unfiltered", imageOf(kSize, [&](int, int) {
         const double value = normal(random);
         return std::array{value, value, value, 1.0};
       }));
  give("unfiltered_variance", imageOf(
                                  kSize,
                                  [](int, int) {
                                    return std::array{0.01, 0.0, 0.0, 0.0};
                                  },
                                  1));
  const Image filtered = draw("filter_reflection.frag", kSize);
  double squares = 0.0;
  for (std::size_t texel = 0; texel < filtered.texelCount(); ++texel) {
    squares += std::pow(filtered.data[4 * texel] - 0.5, 2.0) / static_cast<double>(filtered.texelCount());
  }
  // The binomial's own factor is 9 / 64 = 0.14; the weights by luminance take some of it back.
  EXPECT_LT(squares, 0.20 * 0.01);
}

TEST_P(RoughFilterTest, WithoutVarianceAStepStays) {
  radiance([](int x) { return x < 24 ? 0.25 : 0.75; }, 0.0);
  const Image filtered = draw("filter_reflection.frag", kSize);
  EXPECT_EQ(difference(filtered,
                       imageOf(kSize,
                               [](int x, int) {
                                 const double value = x < 24 ? 0.25 : 0.75;
                                 return std::array{value, value, value, 1.0};
                               }),
                       0.0),
            "");
}

TEST_P(RoughFilterTest, NothingRunsAcrossTheEdgesOfASurface) {
  const auto left = [](int x) { return x < 24; };
  const std::vector<std::function<Surface(int)>> edges = {
      [&](int x) { return Surface{.dist = left(x) ? 4.0 : 5.0}; },
      [&](int x) { return Surface{.normal = left(x) ? glm::dvec3(0, 0, 1) : glm::dvec3(0.8, 0, 0.6)}; },
      [&](int x) { return Surface{.roughness = left(x) ? 0.25 : 0.5}; },
      [&](int x) { return Surface{.mask = left(x) ? 1.0 : 0.0}; }};
  for (const auto& edge : edges) {
    surface(edge);
    radiance([&](int x) { return left(x) ? 0.25 : 0.75; }, 100.0);
    const Image filtered = draw("filter_reflection.frag", kSize);
    EXPECT_EQ(difference(filtered,
                         imageOf(kSize,
                                 [&](int x, int) {
                                   const double value = left(x) ? 0.25 : 0.75;
                                   return std::array{value, value, value, 1.0};
                                 }),
                         1e-5),
              "");
  }
}

// Of equal values all nine count by the binomial alone: the variance of their mean is that of independent
// ones.
TEST_P(RoughFilterTest, TheVarianceIsThatOfAMeanOfIndependentValues) {
  constexpr double kVariance = 0.01;
  radiance([](int) { return 0.5; }, kVariance);
  const Image left = drawAll("filter_reflection.frag", kSize, {Format::kRgba32f, Format::kR32f}).at(1);
  const auto expected = [&](int x, int y) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < 9; ++i) {
      const int dx = i % 3 - 1;
      const int dy = i / 3 - 1;
      const bool is_inside = x + dx >= 0 && x + dx < kSize.width && y + dy >= 0 && y + dy < kSize.height;
      const double weight = is_inside ? std::pow(0.5, std::abs(dx) + std::abs(dy)) : 0.0;
      sum += weight;
      squares += weight * weight;
    }
    return kVariance * squares / (sum * sum);
  };
  EXPECT_EQ(followsFormula(left, expected, 1e-4 * kVariance), "");
}

INSTANTIATE_TEST_SUITE_P(Each, RoughFilterTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
