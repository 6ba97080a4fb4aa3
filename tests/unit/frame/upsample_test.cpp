// Half-resolution tracing: which rays are traced, and what is made of them at full size.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

#include "frame/run_job.h"
#include "made_gbuffers.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr double kHalfUlp = 1.0 / 1024.0;  // of values up to 1 as 16-bit floats
const std::vector<Size> kUpsampledSizes = {{127, 63}, {64, 32}, {2, 3}, {1, 1}};

Size raysOf(Size size) {
  return {(size.width + 1) / 2, (size.height + 1) / 2};
}

constexpr double kNoRay = -1e15;  // NO_RAY_M of joint_bilateral.glsl, as a miss

// What the ray of a texel found: radiance, and whether it hit.
using Found = std::function<std::array<double, 4>(int x, int y)>;

double facingWall(int /*x*/, int /*y*/) {
  return 4.0;
}

bool same(const RayHit& a, const RayHit& b) {
  return std::tie(a.texel_x, a.texel_y, a.px_x, a.px_y, a.t_m, a.ray_class, a.lookups, a.steps) ==
         std::tie(b.texel_x, b.texel_y, b.px_x, b.px_y, b.t_m, b.ray_class, b.lookups, b.steps);
}

class UpsampleTest : public PassTest {
 protected:
  // The reflection at full size over surfaces at `dist`, with what the rays found (alpha 0: a miss).
  [[nodiscard]] Image upsampled(
      const std::string& shader, Size size, const std::function<double(int x, int y)>& dist,
      const Found& found, const std::function<bool(int, int)>& is_traced = [](int, int) { return true; }) {
    begin();
    const Size rays = raysOf(size);
    values_.set("texel_uv", 1.0 / glm::dvec2(size.width, size.height));
    values_.set("rays_uv", 1.0 / glm::dvec2(rays.width, rays.height));
    values_.set("view_per_px", glm::dvec2(1.0, -1.0) / static_cast<double>(size.height));  // f = 2
    give("dist_view",
         imageOf(
             size,
             [&](int x, int y) {
               return std::array{dist(x, y), 0.0, 0.0, 0.0};
             },
             1),
         Format::kR32f);
    give("reflection_half", imageOf(rays, [&](int x, int y) {
           std::array<double, 4> ray = found(2 * x, 2 * y);
           ray[3] = !is_traced(2 * x, 2 * y) ? kNoRay : (ray[3] > 0.0 ? 1.0 : -1.0) * dist(2 * x, 2 * y);
           return ray;
         }));
    return draw(shader, size);
  }
};

TEST_P(UpsampleTest, AConstantStaysConstantAtEverySize) {
  const auto constant = [](int, int) { return std::array{0.25, 0.5, 0.75, 1.0}; };
  for (const Size size : kUpsampledSizes) {
    EXPECT_EQ(
        difference(upsampled("upsample.frag", size, facingWall, constant), imageOf(size, constant), 1e-6),
        "");
  }
}

// Rays at the even texels of a ramp: every texel between them lies on the ramp too, but for the last column
// and row of an even size, beyond which there is no ray.
TEST_P(UpsampleTest, ARampStaysARamp) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const Size size : kUpsampledSizes) {
      const auto ramp = [size](int x, int y) {
        const double last_x = size.width - 1 - (size.width + 1) % 2;
        const double last_y = size.height - 1 - (size.height + 1) % 2;
        return std::array{std::min<double>(x, last_x) / 128, std::min<double>(y, last_y) / 64, 0.5, 1.0};
      };
      const std::string off =
          difference(upsampled(shader, size, facingWall, ramp), imageOf(size, ramp), 1e-6);
      if (!off.empty()) {
        return fmt::format("{}x{}: {}", size.width, size.height, off);
      }
    }
    return "";
  };
  holdsAndKills(check, "upsample.frag", {"upsample_block_centres", "upsample_nearest"});
}

// Two walls that face the camera, one behind the other: what is found on one stays there, wherever the edge
// falls between the rays.
TEST_P(UpsampleTest, NothingBleedsOverAnEdgeOfDepth) {
  const Size size{127, 63};
  const auto check = [&](const std::string& shader) -> std::string {
    for (const int edge : {30, 31, 32, 33}) {
      const auto sides = [edge](int x, int) {
        return std::array<double, 4>{x < edge ? 1.0 : 0.0, x < edge ? 0.0 : 1.0, 0, 1};
      };
      const auto walls = [edge](int x, int) { return x < edge ? 2.0 : 2.05; };
      const std::string off = difference(upsampled(shader, size, walls, sides), imageOf(size, sides), 0.0);
      if (!off.empty()) {
        return fmt::format("edge at {}: {}", edge, off);
      }
    }
    return "";
  };
  holdsAndKills(check, "upsample.frag", {"upsample_without_guide"});
}

// Two walls that meet: distance is continuous over the crease, and no texel but those beside it takes from
// both.
TEST_P(UpsampleTest, ACreaseIsFoundByThePlanesItParts) {
  const Size size{127, 63};
  for (const int edge : {30, 31}) {
    // On the right the plane through (x_edge, 4 m) with normal (-0.8, 0, 0.6).
    const auto slope = [&](double x) { return (x - 0.5 * size.width) / size.height; };
    const auto walls = [&](int x, int) {
      return x < edge ? 4.0 : (2.4 + 0.8 * 4.0 * slope(edge)) / (0.6 + 0.8 * slope(x + 0.5));
    };
    const auto sides = [edge](int x, int) {
      return std::array<double, 4>{x < edge ? 1.0 : 0.0, x < edge ? 0.0 : 1.0, 0, 1};
    };
    const Image got = upsampled("upsample.frag", size, walls, sides);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const bool is_beside = x == edge - 1 || x == edge;
        const float red = got.at(x, y, 0);
        ASSERT_TRUE(is_beside ? red == 0.0F || red == 1.0F : red == (x < edge ? 1.0F : 0.0F))
            << x << " " << y;
      }
    }
  }
}

// A floor that runs to the horizon: neighbouring rows lie metres apart and are one surface.
TEST_P(UpsampleTest, AFloorAtAGrazingAngleIsOneSurface) {
  const Size size{64, 128};
  const int horizon = size.height / 2;
  const auto floor = [&](int, int y) { return y < horizon ? 1e4 : 64.0 / (y + 0.5 - horizon); };
  const auto rows = [&](int, int y) {
    const double row = std::min(y, size.height - 2);
    return std::array{y < horizon ? 0.0 : row / 128, 0.25, 0.5, 1.0};
  };
  EXPECT_EQ(difference(upsampled("upsample.frag", size, floor, rows), imageOf(size, rows), 1e-6), "");
}

// Where the ray was masked its neighbours answer; a miss is an answer and lowers the alpha, not the colour.
TEST_P(UpsampleTest, WhatWasNotTracedCountsForNothingAndAMissIsNoColour) {
  const Size size{32, 32};
  const auto found = [](int x, int) {
    return x < 16 ? std::array{0.5, 0.25, 1.0, 1.0} : std::array{0.0, 0.0, 0.0, 0.0};
  };
  const auto expected = [](int x, int) {
    const double hits = x == 15 ? 0.5 : x < 15 ? 1.0 : 0.0;
    return hits > 0.0 ? std::array{0.5, 0.25, 1.0, hits} : std::array{0.0, 0.0, 0.0, 0.0};
  };
  EXPECT_EQ(difference(upsampled("upsample.frag", size, facingWall, found), imageOf(size, expected), 1e-6),
            "");
  const auto traced = [](int x, int) { return x % 4 == 0; };
  const auto holes = [](int x, int) {
    return x % 4 == 2 || x >= 15 ? std::array{0.0, 0.0, 0.0, 0.0} : std::array{0.5, 0.25, 1.0, 1.0};
  };
  EXPECT_EQ(
      difference(upsampled("upsample.frag", size, facingWall, found, traced), imageOf(size, holes), 1e-6),
      "");
}

// The rays of a half-resolution trace are those of the full one, bit for bit, at the blocks' upper left
// texels.
TEST_P(UpsampleTest, HalfResolutionTracesEveryOtherTexelsRayOverTheFullDepth) {
  for (const Size size : {Size{127, 63}, Size{64, 32}, Size{1, 1}}) {
    Job job = randomBlocks(size);
    job.traces = {{.stage = "hiz", .technique = "mirror"}, {.stage = "hiz", .technique = "half_res"}};
    const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
    ASSERT_TRUE(result.has_value()) << sentence(result.error());
    const RayRecord& full = result->traces[0].record;
    const RayRecord& half = result->traces[1].record;
    ASSERT_EQ(half.size, size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const bool is_traced = x % 2 == 0 && y % 2 == 0;
        RayHit expected = full.at(x, y);
        if (!is_traced) {
          const bool is_background = full.at(x, y).ray_class == RayClass::kBackground;
          expected = RayHit{.ray_class = is_background ? RayClass::kBackground : RayClass::kMasked};
        }
        ASSERT_TRUE(same(half.at(x, y), expected)) << x << " " << y;
        ASSERT_EQ(result->traces[1].images.at("material").at(x, y, 2), is_traced ? 1.0F : 0.0F);
      }
    }
    for (int y = 0; y < size.height; y += 2) {
      for (int x = 0; x < size.width; x += 2) {
        for (const std::size_t channel : {0U, 1U, 2U, 3U}) {
          ASSERT_NEAR(result->traces[1].images.at("reflection").at(x, y, channel),
                      result->traces[0].images.at("reflection").at(x, y, channel), 4 * kHalfUlp)
              << x << " " << y;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, UpsampleTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
