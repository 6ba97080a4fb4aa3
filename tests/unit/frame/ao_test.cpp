// Ambient obscurance over planes and corners whose value has a closed form, and its blur.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "frame/gbuffer_source.h"
#include "infinity.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr double kSamplingError = 0.025;  // of four columns' mean: 32 points in each of sixteen turns

Camera camera(Size size) {
  return {.size = size,
          .clip_from_view =
              perspective(2.0 * std::atan(0.5), static_cast<double>(size.width) / size.height, 0.1, 100.0),
          .view_from_world = glm::dmat4(1.0),
          .near_m = 0.1,
          .far_m = 100.0};
}

// x / dist_view and y / dist_view of a texel's centre.
glm::dvec2 slopeAt(Size size, int x, int y) {
  const PixelProjection projection = pixelProjection(camera(size));
  return (glm::dvec2(x + 0.5, y + 0.5) - projection.px_offset) / projection.px_scale;
}

class AoTest : public PassTest {
 protected:
  struct Texel {
    double dist_view = static_cast<double>(kInfinity);
    glm::dvec3 normal{0, 0, 0};
  };

  void giveSurfaces(Size size, double radius_m, int sample_count,
                    const std::function<Texel(const glm::dvec2& ray)>& surface) {
    begin();
    size_ = size;
    setCameraUniforms(values_, camera(size));
    values_.set("ao_radius_m", radius_m);
    values_.set("ao_thickness_m", 2.0 * radius_m);
    setConstant("ao_sample_count", sample_count);
    Image dist_view(size, {"Z"});
    Image normal_view(size, {"R", "G", "B", "A"});
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Texel texel = surface(slopeAt(size, x, y));
        dist_view.at(x, y) = static_cast<float>(texel.dist_view);
        for (int i = 0; i < 3; ++i) {
          normal_view.at(x, y, static_cast<std::size_t>(i)) = static_cast<float>(texel.normal[i]);
        }
      }
    }
    give("dist_view", dist_view, Format::kR32f);
    give("normal_view", normal_view);
  }

  void giveNoisy(const Image& noisy) {
    begin();
    size_ = noisy.size;
    setCameraUniforms(values_, camera(noisy.size));
    give("ao_noisy", noisy, Format::kRg32f);
  }

  // Both directions, as the frame draws them.
  [[nodiscard]] Image blurred(const std::string& shader = "ao_blur.frag") {
    values_.set("ao_blur_down", 0);
    const Image across = draw(shader, size_, Format::kRg32f);
    give("ao_noisy", across, Format::kRg32f);
    values_.set("ao_blur_down", 1);
    return draw(shader, size_, Format::kRg32f);
  }

  [[nodiscard]] Image ao(const std::string& shader = "ao.frag") {
    return draw(shader, size_, Format::kRg32f);
  }

  Size size_;
};

// The plane through (0, 0, -distance_m) with a unit normal towards the camera.
std::function<double(const glm::dvec2&)> planeDist(const glm::dvec3& normal, double distance_m) {
  return [=](const glm::dvec2& ray) {
    // normal . (dist * (ray, -1)) = normal . (0, 0, -distance_m)
    const double along = glm::dot(normal, glm::dvec3(ray, -1.0));
    return along < -1e-3 ? -normal.z * distance_m / along : static_cast<double>(kInfinity);
  };
}

std::string visibilityIs(const Image& ao, float expected) {
  for (int y = 0; y < ao.size.height; ++y) {
    for (int x = 0; x < ao.size.width; ++x) {
      if (ao.at(x, y) != expected) {
        return fmt::format("{} at ({}, {})", ao.at(x, y), x, y);
      }
    }
  }
  return "";
}

TEST_P(AoTest, APlaneIsExactlyOneFromAnyAngle) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const double tilt_deg : {0.0, 30.0, 60.0, 80.0, 86.0}) {
      for (const double turn_deg : {0.0, 40.0, 90.0}) {
        const double tilt = tilt_deg * std::numbers::pi / 180.0;
        const double turn = turn_deg * std::numbers::pi / 180.0;
        const glm::dvec3 normal(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                                std::cos(tilt));
        const auto dist = planeDist(normal, 4.0);
        giveSurfaces({61, 47}, 0.5, 16, [&](const glm::dvec2& ray) { return Texel{dist(ray), normal}; });
        if (const std::string found = visibilityIs(ao(shader), 1.0F); !found.empty()) {
          return fmt::format("tilt {}, turn {}: {}", tilt_deg, turn_deg, found);
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "ao.frag", {"ao_without_plane"});
}

// A point of one plane, `a` radii from another that meets it under a right angle and does not end. With x the
// share of the direction along the other's normal, whose density under the cosine is that of a disc's points,
// 2/pi sqrt(1 - x^2):
//   1 - integral from a to 1 of (1 - a / x) 2/pi sqrt(1 - x^2) dx
double cornerVisibility(double a) {
  if (a >= 1.0) {
    return 1.0;
  }
  const double root = std::sqrt(1.0 - a * a);
  const double disc = 0.5 * (std::numbers::pi / 2.0 - std::asin(a) - a * root);
  const double over_x = a > 0.0 ? std::log((1.0 + root) / a) - root : 0.0;
  return 1.0 - 2.0 / std::numbers::pi * (disc - a * over_x);
}

// Two walls that meet four metres ahead along a vertical edge, each turned by 45 degrees.
TEST_P(AoTest, ARightAngleHasItsClosedForm) {
  EXPECT_NEAR(cornerVisibility(0.0), 0.5, 1e-12);
  const Size size{400, 120};
  const double radius_m = 0.8;
  const auto check = [&](const std::string& shader) -> std::string {
    giveSurfaces(size, radius_m, 32, [](const glm::dvec2& ray) {
      const double side = ray.x < 0.0 ? -1.0 : 1.0;
      return Texel{4.0 / (1.0 + std::abs(ray.x)), glm::normalize(glm::dvec3(-side, 0, 1))};
    });
    const Image drawn = ao(shader);
    for (int first = 0; first + 4 <= size.width; ++first) {
      double found = 0.0;
      double expected = 0.0;
      for (int x = first; x < first + 4; ++x) {
        for (int y = 30; y < 90; ++y) {
          found += drawn.at(x, y) / 240.0;
        }
        const glm::dvec2 ray = slopeAt(size, x, 60);
        const double across_m = std::abs(ray.x) * 4.0 / (1.0 + std::abs(ray.x));
        expected += cornerVisibility(std::numbers::sqrt2 * across_m / radius_m) / 4.0;
      }
      if (!(std::abs(found - expected) < kSamplingError)) {
        return fmt::format("columns from {}: {}, expected {}", first, found, expected);
      }
    }
    return "";
  };
  holdsAndKills(check, "ao.frag", {"ao_uniform_directions"});
}

// A plate two metres ahead, a wall at six: the plate is no part of the wall's surroundings.
TEST_P(AoTest, WhatStandsFarInFrontCastsNoHalo) {
  const auto check = [&](const std::string& shader) {
    giveSurfaces({64, 48}, 0.5, 16, [](const glm::dvec2& ray) {
      return Texel{ray.x < 0.0 ? 2.0 : 6.0, {0, 0, 1}};
    });
    return visibilityIs(ao(shader), 1.0F);
  };
  holdsAndKills(check, "ao.frag", {"ao_endless_columns"});
}

TEST_P(AoTest, BackgroundIsOneAndCoversNothing) {
  giveSurfaces({33, 17}, 0.5, 16, [](const glm::dvec2& ray) {
    return ray.y > 0.0 ? Texel{} : Texel{3.0, {0, 0, 1}};
  });
  EXPECT_EQ(visibilityIs(ao(), 1.0F), "");
}

TEST_P(AoTest, ImagesOfAnySizeAreDrawn) {
  for (const Size size : {Size{1, 1}, {3, 1}, {1, 5}, {7, 3}}) {
    giveSurfaces(size, 0.5, 8, [](const glm::dvec2&) { return Texel{3.0, {0, 0, 1}}; });
    const Image drawn = ao();
    EXPECT_EQ(visibilityIs(drawn, 1.0F), "");
    giveNoisy(drawn);
    EXPECT_EQ(visibilityIs(blurred(), 1.0F), "");
  }
}

TEST_P(AoTest, ABlurKeepsTheBitsOfAConstantImage) {
  Image noisy({37, 23}, {"R", "G"});
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) {
      noisy.at(x, y, 0) = 0.3F;
      noisy.at(x, y, 1) =
          x > 30 && y > 15 ? kInfinity : 3.0F + 0.05F * static_cast<float>((x * 7 + y * 13) % 11);
    }
  }
  const auto check = [&](const std::string& shader) {
    giveNoisy(noisy);
    return visibilityIs(blurred(shader), 0.3F);
  };
  holdsAndKills(check, "ao_blur.frag", {"ao_blur_plain_mean"});
}

TEST_P(AoTest, ABlurDoesNotCrossAnEdge) {
  Image noisy({37, 23}, {"R", "G"});
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) {
      const bool is_near = x + y < 30;
      noisy.at(x, y, 0) = is_near ? 1.0F : 0.0F;
      noisy.at(x, y, 1) = is_near ? 3.0F : 3.5F;
    }
  }
  const auto check = [&](const std::string& shader) {
    giveNoisy(noisy);
    return difference(blurred(shader), noisy, 0.0);
  };
  holdsAndKills(check, "ao_blur.frag", {"ao_blur_across_edges"});
}

// A floor seen under 6 degrees: from row to row its distance grows by up to a fifth.
TEST_P(AoTest, ABlurTakesThePatternOutOfASlantedPlane) {
  const Size size{40, 60};
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.05, 1, 0.1));
  const auto dist = planeDist(normal, 40.0);
  Image noisy(size, {"R", "G"});
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      noisy.at(x, y, 0) = static_cast<float>(4 * (y % 4) + (x % 4));
      noisy.at(x, y, 1) = static_cast<float>(dist(slopeAt(size, x, y)));
    }
  }
  giveNoisy(noisy);
  const Image smooth = blurred();
  int seen = 0;
  for (int y = 2; y < size.height - 2; ++y) {
    for (int x = 2; x < size.width - 2; ++x) {
      if (std::isfinite(noisy.at(x - 2, y - 2, 1)) && std::isfinite(noisy.at(x + 2, y - 2, 1))) {
        ASSERT_NEAR(smooth.at(x, y), 7.5, 1e-5) << x << ", " << y;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 500);
}

INSTANTIATE_TEST_SUITE_P(Each, AoTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
