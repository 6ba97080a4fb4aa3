// The gloss blur against scalar code in double precision.
#include <fmt/format.h>

#include <random>

#include "scalar_blur.h"

namespace ssrkit {
namespace {

class BlurTest : public PassTest {
 protected:
  Image blurAxis(const std::string& shader, const BlurredSurface& surface, const Image& source, int along_y,
                 Format format = Format::kRgba32f) {
    begin();
    values_.set("size_px", glm::dvec2(kBlurSize.width, kBlurSize.height));
    values_.set("px_scale", glm::dvec2(kBlurPxScale, -kBlurPxScale));
    values_.set("px_offset", glm::dvec2(kBlurSize.width / 2.0, kBlurSize.height / 2.0));
    values_.set("view_per_px", 1.0 / glm::dvec2(kBlurPxScale, -kBlurPxScale));
    values_.set("texel_uv", 1.0 / glm::dvec2(kBlurSize.width, kBlurSize.height));
    values_.set("along_y", along_y);
    values_.set("narrow", narrow_);
    give("source", source, format);
    give("blur_guide",
         imageOf(
             kBlurSize,
             [&](int x, int y) {
               return std::array<double, 4>{surface.dist_view(x, y), surface.radius_px(x, y)};
             },
             2),
         Format::kRg32f);
    give("normal_view", imageOf(kBlurSize, surface.normal));
    return draw(shader, kBlurSize, format);
  }
  int narrow_ = 0;
  Image blur(const std::string& shader, const BlurredSurface& surface, Format format = Format::kRgba32f) {
    const Image along_x = blurAxis(shader, surface, imageOf(kBlurSize, surface.source), 0, format);
    return blurAxis(shader, surface, along_x, 1, format);
  }
};

std::array<double, 4> impulse(int x, int y) {
  return {x == 30 && y == 23 ? 1.0 : 0.0, 0.0, 0.0, 1.0};
}

TEST_P(BlurTest, AnImpulseBecomesTheSeparableKernel) {
  const Image blurred = blur("gloss_blur.frag", {.source = impulse});
  const auto kernel = [](int d) { return std::pow(std::max(1.0 - d * d / 36.0, 0.0), 2); };
  double sum = 0.0;
  for (int d = -6; d <= 6; ++d) {
    sum += kernel(d);
  }
  EXPECT_EQ(
      difference(blurred,
                 imageOf(kBlurSize,
                         [&](int x, int y) {
                           return std::array{kernel(x - 30) * kernel(y - 23) / (sum * sum), 0.0, 0.0, 1.0};
                         }),
                 1e-7),
      "");
}

TEST_P(BlurTest, TheNarrowKernelIsAsWideAsTheGapsOfTheWideOne) {
  narrow_ = 1;
  // 30 px in 12 taps are 3 px apart: a radius of 6. Up to 12 px there are no gaps, and nothing is blurred.
  const auto kernel = [](int d) { return std::pow(std::max(1.0 - d * d / 36.0, 0.0), 2); };
  double sum = kernel(0);
  for (int d = 1; d < 6; ++d) {
    sum += 2.0 * kernel(d);
  }
  EXPECT_EQ(
      difference(blur("gloss_blur.frag", {.source = impulse, .radius_px = [](int, int) { return 30.0; }}),
                 imageOf(kBlurSize,
                         [&](int x, int y) {
                           return std::array{kernel(x - 30) * kernel(y - 23) / (sum * sum), 0.0, 0.0, 1.0};
                         }),
                 1e-6),
      "");
  EXPECT_EQ(
      difference(blur("gloss_blur.frag", {.source = impulse, .radius_px = [](int, int) { return 12.0; }}),
                 imageOf(kBlurSize, impulse), 0.0),
      "");
}

// A bright line, blurred 30 px wide, must fall off to either side; the wide kernel's spaced taps alone leave
// a comb.
TEST_P(BlurTest, NarrowBeforeWideLeavesNoComb) {
  const auto line = [](int x, int) { return std::array{x == 30 ? 1.0 : 0.0, 0.0, 0.0, 1.0}; };
  const BlurredSurface surface{.source = line, .radius_px = [](int, int) { return 30.0; }};
  const auto largest_rise = [](const Image& image) {  // of the peak's share
    float rise = 0.0F;
    for (int x = 31; x < kBlurSize.width; ++x) {
      rise = std::max(rise, image.at(x, 20) - image.at(x - 1, 20));
    }
    return rise / image.at(30, 20);
  };
  EXPECT_GT(largest_rise(blurAxis("gloss_blur.frag", surface, imageOf(kBlurSize, line), 0)), 0.9F);
  narrow_ = 1;
  const Image narrow = blurAxis("gloss_blur.frag", surface, imageOf(kBlurSize, line), 0);
  narrow_ = 0;
  EXPECT_LT(largest_rise(blurAxis("gloss_blur.frag", surface, narrow, 0)), 0.01F);
}

// Random colours, alphas, radii up to spaced taps, a tilted plane, a turned patch and a step of depth.
TEST_P(BlurTest, EveryTexelIsTheWeightedMeanOfScalarCode) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<std::array<double, 4>> noise;
  for (int i = 0; i < kBlurSize.width * kBlurSize.height; ++i) {
    const double alpha = unit(random) < 0.3 ? 0.0 : unit(random);
    noise.push_back({alpha > 0.0 ? unit(random) : 0.0, alpha > 0.0 ? unit(random) : 0.0, 0.0, alpha});
  }
  const auto at = [&](int x, int y) {
    return noise.at(static_cast<std::size_t>(y) * kBlurSize.width + static_cast<std::size_t>(x));
  };
  const BlurredSurface surface{
      .source = at,
      .dist_view = [](int x, int y) { return (x < 40 ? 5.0 : 5.5) + 0.002 * y; },
      .radius_px = [&](int x, int y) { return x % 7 == 3 ? -1.0 : 20.0 * at(y, x % 40)[0]; },
      .normal =
          [](int x, int y) {
            const double turn = y > 30 && x < 20 ? 0.3 : 0.02 * std::sin(0.5 * x);
            return std::array{std::sin(turn), 0.0, std::cos(turn), 1.0};
          }};
  const Image source = imageOf(kBlurSize, at);
  for (const bool along_y : {false, true}) {
    const Image expected = blurredAlong(surface, source, along_y);
    EXPECT_EQ(difference(blurAxis("gloss_blur.frag", surface, source, along_y ? 1 : 0), expected, 2e-4), "");
  }
}

TEST_P(BlurTest, AConstantStaysItselfBitForBit) {
  const Image blurred = blur("gloss_blur.frag",
                             {.source =
                                  [](int, int) {
                                    return std::array{0.7998046875, 3.30078125, 0.125, 1.0};
                                  },
                              .radius_px = [](int x, int y) { return 0.4 * ((x + 3 * y) % 50); }},
                             Format::kRgba16f);
  for (std::size_t i = 0; i < blurred.data.size(); i += 4) {
    ASSERT_EQ(blurred.data[i], 0.7998046875F);
    ASSERT_EQ(blurred.data[i + 1], 3.30078125F);
    ASSERT_EQ(blurred.data[i + 2], 0.125F);
    ASSERT_EQ(blurred.data[i + 3], 1.0F);
  }
}

TEST_P(BlurTest, MissesLeaveNoDarkRim) {
  const auto check = [this](const std::string& shader) -> std::string {
    const Image blurred =
        blur(shader, {.source = [](int x, int) {
               return x < 30 ? std::array{0.5, 0.5, 0.5, 1.0} : std::array{0.0, 0.0, 0.0, 0.0};
             }});
    for (int x = 0; x < kBlurSize.width; ++x) {
      const float alpha = blurred.at(x, 20, 3);
      if (alpha > 0.0F && std::abs(blurred.at(x, 20) - 0.5F) > 1e-6F) {
        return fmt::format("column {} has {} of 0.5 left", x, blurred.at(x, 20));
      }
      if (x > 0 && alpha > blurred.at(x - 1, 20, 3) + 1e-6F) {
        return fmt::format("alpha rises at column {}", x);
      }
    }
    return "";
  };
  holdsAndKills(check, "gloss_blur.frag", {"blur_straight_alpha"});
}

TEST_P(BlurTest, NothingCrossesAStepOfDepth) {
  const auto colour = [](int x, int) {
    return x < 30 ? std::array{1.0, 0.0, 0.0, 1.0} : std::array{0.0, 1.0, 0.0, 1.0};
  };
  const auto check = [&](const std::string& shader) {
    return difference(
        blur(shader, {.source = colour, .dist_view = [](int x, int) { return x < 30 ? 5.0 : 5.2; }}),
        imageOf(kBlurSize, colour), 1e-6);
  };
  holdsAndKills(check, "gloss_blur.frag", {"blur_crosses_depth"});
}

TEST_P(BlurTest, NothingCrossesAnEdgeOfTheNormal) {
  const auto colour = [](int, int y) {
    return y < 20 ? std::array{1.0, 0.0, 0.0, 1.0} : std::array{0.0, 1.0, 0.0, 1.0};
  };
  EXPECT_EQ(
      difference(blur("gloss_blur.frag",
                      {.source = colour,
                       .normal =
                           [](int, int y) {
                             return y < 20 ? std::array{0.0, 0.0, 1.0, 1.0} : std::array{0.0, 0.6, 0.8, 1.0};
                           }}),
                 imageOf(kBlurSize, colour), 1e-6),
      "");
}

INSTANTIATE_TEST_SUITE_P(Each, BlurTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
