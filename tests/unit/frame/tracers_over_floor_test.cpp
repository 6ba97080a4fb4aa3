// The tracers over a level mirror floor, with a wall or without, whose answers have closed forms.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "made_gbuffers.h"
#include "tracer_fixture.h"

namespace ssrkit {
namespace {

const Size kTallFloorSize{64, 256};

class TracersOverFloorTest : public TracerFixture {};

// A level floor mirrors; above it is nothing, or a wall that does not mirror.
TEST_P(TracersOverFloorTest, PixelsWithoutARaySayWhy) {
  for (const bool has_wall : {false, true}) {
    const double wall_m = has_wall ? 8.0 : std::numeric_limits<double>::infinity();
    const RayRecord record = trace(floorAndWall(kTallFloorSize, wall_m), "walk", {}, "");
    for (int x = 0; x < kTallFloorSize.width; ++x) {
      const RayHit& above = record.at(x, kTallFloorSize.height / 4);
      EXPECT_EQ(above.ray_class, has_wall ? RayClass::kMasked : RayClass::kBackground) << x;
      EXPECT_EQ(above.lookups, 0U) << x;
      EXPECT_EQ(above.texel_x, -1) << x;
      EXPECT_GT(record.at(x, kTallFloorSize.height - 1).lookups, 0U) << x;
    }
  }
}

// A G-buffer of one's own may leave `material`'s alpha at 1 where there is nothing.
TEST_P(TracersOverFloorTest, BackgroundThatIsTakenForASurfaceIsStillBackground) {
  const std::filesystem::path everywhere =
      std::filesystem::temp_directory_path() / fmt::format("ssrkit_everywhere_{}.frag", getpid());
  std::ofstream(everywhere) << "#version 450\nlayout(location = 0) out uvec4 ray_work;\n"
                               "void main() { ray_work = uvec4(0); gl_FragDepth = 1.0; }\n";
  Job job = floorAndWall(kTallFloorSize, std::numeric_limits<double>::infinity());
  job.replacements = {{.pass = "without_ray", .file = everywhere}};
  const RayRecord record = trace(job, "walk", {}, "");
  std::filesystem::remove(everywhere);
  for (int x = 0; x < kTallFloorSize.width; ++x) {
    const RayHit& above = record.at(x, kTallFloorSize.height / 4);
    EXPECT_EQ(above.ray_class, RayClass::kBackground) << x;
    EXPECT_EQ(above.lookups, 0U) << x;
    EXPECT_EQ(above.texel_x, -1) << x;
  }
}

// A floor without a wall, and rays of at most 100 m: nothing is hit. Every ray comes to its end, also in as
// many steps as there are, moved back by up to a whole one, and in steps too short for so many.
TEST_P(TracersOverFloorTest, TheMostStepsReachEveryRaysEnd) {
  const Job job = floorAndWall({4, 24}, std::numeric_limits<double>::infinity());
  for (const std::string stage : {"naive", "world", "refined", "exponential", "adaptive"}) {
    for (const double step_m : {0.0, 1e-4}) {
      for (const double jitter : {0.0, 1.0}) {
        const RayRecord record = trace(
            job, stage,
            {.max_distance_m = 100.0, .step_count = kMaxStepCount, .step_m = step_m, .jitter = jitter}, "");
        EXPECT_EQ(std::ranges::count(record.rays, RayClass::kBudget, &RayHit::ray_class), 0)
            << stage << ", step_m " << step_m << ", jitter " << jitter;
      }
    }
  }
}

// Every ray meets the wall between two samples, and with dither by a whole step the part of the step that it
// is behind the wall is anything from nothing to all, of neighbours too: mean 1/2, variance 1/12.
TEST_P(TracersOverFloorTest, DitherMovesTheSamplesOfNeighboursApart) {
  constexpr int kStridePx = 16;
  const RayRecord record = trace(floorAndWall(kTallFloorSize, 8.0), "homogeneous",
                                 {.bisection_count = 0, .stride_px = kStridePx, .jitter = 1.0}, "");
  int rows = 0;
  for (int y = 0; y < kTallFloorSize.height; ++y) {
    double sum = 0.0;
    double squares = 0.0;
    for (int x = 0; x < kTallFloorSize.width; ++x) {
      const RayHit& ray = record.at(x, y);
      if (ray.ray_class != RayClass::kHit) {
        break;
      }
      // Row y mirrors at the wall's foot, px_y 160, into 320 - (y + 0.5); what lies behind it is higher up.
      const double behind = (319.5 - y - static_cast<double>(ray.px_y)) / kStridePx;
      sum += behind / kTallFloorSize.width;
      squares += behind * behind / kTallFloorSize.width;
      rows += x + 1 == kTallFloorSize.width ? 1 : 0;
    }
    if (rows > 0 && sum > 0.0) {
      EXPECT_NEAR(sum, 0.5, 0.1) << y;
      EXPECT_NEAR(squares - sum * sum, 1.0 / 12.0, 0.03) << y;
    }
  }
  EXPECT_GT(rows, 60);
}

// M1 without its wall: a ray is M = 2 (row + 0.5) - height pixels from its vanishing point. Its samples end
// half a pixel before it, at M^2 / (M + 0.5), so ceil of that over N are looked at, and none beyond.
TEST_P(TracersOverFloorTest, HomogeneousStepsEndBeforeTheVanishingPoint) {
  const auto check = [&](const std::string& shader) -> std::string {
    const Job job = floorAndWall(kTallFloorSize, std::numeric_limits<double>::infinity());
    for (const int stride : {1, 4, 10, 33}) {
      const RayRecord record = trace(job, "homogeneous", {.stride_px = stride}, shader);
      for (int y = kTallFloorSize.height / 2; y < kTallFloorSize.height; ++y) {
        const double to_vanishing_px = 2.0 * (y + 0.5) - kTallFloorSize.height;
        const double samples =
            std::ceil(to_vanishing_px * to_vanishing_px / (to_vanishing_px + 0.5) / stride);
        for (int x = 0; x < kTallFloorSize.width; ++x) {
          const RayHit& ray = record.at(x, y);
          if (ray.ray_class != RayClass::kRange || ray.steps != samples) {
            return fmt::format("stride {} pixel {}, {}: {} after {} steps, not RANGE after {}", stride, x, y,
                               name(ray.ray_class), ray.steps, samples);
          }
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "trace_homogeneous.frag", {"homogeneous_no_guard"});
}

INSTANTIATE_TEST_SUITE_P(Each, TracersOverFloorTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);

}  // namespace
}  // namespace ssrkit
