// The gloss blur against scalar code in double precision.
#include <fmt/format.h>

#include <random>

#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr Size kSize{61, 47};
constexpr double kPxScale = 80.0;
constexpr double kDist = 5.0;

// What a blur is given: a function of the texel for each image.
struct Surface {
  std::function<std::array<double, 4>(int x, int y)> source;
  std::function<double(int x, int y)> dist_view = [](int, int) { return kDist; };
  std::function<double(int x, int y)> radius_px = [](int, int) { return 6.0; };
  std::function<std::array<double, 4>(int x, int y)> normal = [](int, int) {
    return std::array{0.0, 0.0, 1.0, 1.0};
  };
};

// Position in view space, the image's middle on the axis.
glm::dvec3 positionView(const Surface& surface, int x, int y) {
  const double dist = surface.dist_view(x, y);
  return {dist * (x + 0.5 - kSize.width / 2.0) / kPxScale, -dist * (y + 0.5 - kSize.height / 2.0) / kPxScale,
          -dist};
}

// Weight of one texel in another's blur along one axis, `offset` texels away.
double weightOf(const Surface& surface, int x, int y, int other_x, int other_y, int offset) {
  const double radius = std::min(surface.radius_px(x, y), surface.radius_px(other_x, other_y));
  if (radius <= 0.0) {
    return 0.0;
  }
  const auto own = surface.normal(x, y);
  const auto other = surface.normal(other_x, other_y);
  const glm::dvec3 normal(own[0], own[1], own[2]);
  const double off_plane =
      std::abs(glm::dot(normal, positionView(surface, other_x, other_y) - positionView(surface, x, y)));
  const double plane = std::max(1.0 - off_plane / (0.01 * surface.dist_view(x, y)), 0.0);
  const double turned =
      std::max((glm::dot(normal, glm::dvec3(other[0], other[1], other[2])) - 0.9) / 0.1, 0.0);
  const double share = offset / radius;
  return std::pow(std::max(1.0 - share * share, 0.0), 2) * plane * turned;
}

// One axis in double precision: every tap within the radius, weighed, colours times alpha.
Image blurredAlong(const Surface& surface, const Image& source, bool along_y) {
  return imageOf(kSize, [&](int x, int y) {
    const double radius = surface.radius_px(x, y);
    std::array<double, 4> sum{};
    double weights = 0.0;
    const double spacing = std::max(radius / 12.0, 1.0);
    for (int tap = -12; tap <= 12; ++tap) {
      const auto offset = static_cast<int>(std::nearbyint(tap * spacing));
      const int other_x = along_y ? x : x + offset;
      const int other_y = along_y ? y + offset : y;
      if (other_x < 0 || other_y < 0 || other_x >= kSize.width || other_y >= kSize.height) {
        continue;
      }
      const double weight = tap == 0 ? 1.0 : weightOf(surface, x, y, other_x, other_y, offset);
      weights += weight;
      for (std::size_t channel = 0; channel < 4; ++channel) {
        const auto alpha = static_cast<double>(source.at(other_x, other_y, 3));
        sum[channel] +=
            weight *
            (channel < 3 ? alpha * static_cast<double>(source.at(other_x, other_y, channel)) : alpha);
      }
    }
    const double alpha = std::max(sum[3], 1e-30);
    return radius <= 1.0 ? std::array<double, 4>{source.at(x, y, 0), source.at(x, y, 1), source.at(x, y, 2),
                                                 source.at(x, y, 3)}
                         : std::array{sum[0] / alpha, sum[1] / alpha, sum[2] / alpha, sum[3] / weights};
  });
}

class BlurTest : public PassTest {
 protected:
  Image blurAxis(const std::string& shader, const Surface& surface, const Image& source, int along_y,
                 Format format = Format::kRgba32f) {
    begin();
    values_.set("size_px", glm::dvec2(kSize.width, kSize.height));
    values_.set("px_scale", glm::dvec2(kPxScale, -kPxScale));
    values_.set("px_offset", glm::dvec2(kSize.width / 2.0, kSize.height / 2.0));
    values_.set("view_per_px", 1.0 / glm::dvec2(kPxScale, -kPxScale));
    values_.set("along_y", along_y);
    give("source", source, format);
    give("blur_guide",
         imageOf(
             kSize,
             [&](int x, int y) {
               return std::array<double, 4>{surface.dist_view(x, y), surface.radius_px(x, y)};
             },
             2),
         Format::kRg32f);
    give("normal_view", imageOf(kSize, surface.normal));
    return draw(shader, kSize, format);
  }
  Image blur(const std::string& shader, const Surface& surface, Format format = Format::kRgba32f) {
    const Image along_x = blurAxis(shader, surface, imageOf(kSize, surface.source), 0, format);
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
                 imageOf(kSize,
                         [&](int x, int y) {
                           return std::array{kernel(x - 30) * kernel(y - 23) / (sum * sum), 0.0, 0.0, 1.0};
                         }),
                 1e-7),
      "");
}

// Random colours, alphas, radii up to spaced taps, a tilted plane, a turned patch and a step of depth.
TEST_P(BlurTest, EveryTexelIsTheWeightedMeanOfScalarCode) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<std::array<double, 4>> noise;
  for (int i = 0; i < kSize.width * kSize.height; ++i) {
    const double alpha = unit(random) < 0.3 ? 0.0 : unit(random);
    noise.push_back({alpha > 0.0 ? unit(random) : 0.0, alpha > 0.0 ? unit(random) : 0.0, 0.0, alpha});
  }
  const auto at = [&](int x, int y) { return noise[static_cast<std::size_t>(y * kSize.width + x)]; };
  const Surface surface{
      .source = at,
      .dist_view = [](int x, int y) { return (x < 40 ? 5.0 : 5.5) + 0.002 * y; },
      .radius_px = [&](int x, int y) { return x % 7 == 3 ? -1.0 : 20.0 * at(y, x % 40)[0]; },
      .normal =
          [](int x, int y) {
            const double turn = y > 30 && x < 20 ? 0.3 : 0.02 * std::sin(0.5 * x);
            return std::array{std::sin(turn), 0.0, std::cos(turn), 1.0};
          }};
  const Image source = imageOf(kSize, at);
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
    for (int x = 0; x < kSize.width; ++x) {
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
        imageOf(kSize, colour), 1e-6);
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
                 imageOf(kSize, colour), 1e-6),
      "");
}

INSTANTIATE_TEST_SUITE_P(Each, BlurTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
