// The tracer variants against their marches in double precision, and the mutants that each check must kill.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <tuple>

#include "frame/run_job.h"
#include "frame/stages.h"
#include "made_gbuffers.h"
#include "march_reference.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

const Size kBlocksSize{96, 64};
const Size kFloorSize{64, 256};

class TracersTest : public PassTest {
 protected:
  // An absolute path in the place of the stage's own shader is a mutant's.
  [[nodiscard]] RayRecord trace(Job job, const std::string& stage, const TraceParameters& parameters,
                                const std::string& shader) {
    job.traces = {{.stage = stage, .parameters = parameters, .technique = ""}};
    job.want_gbuffer = false;
    if (shader.starts_with('/')) {
      job.replacements = {{.pass = stage, .file = shader}};
    }
    const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
    EXPECT_TRUE(result.has_value()) << sentence(result.error());
    return result ? result->traces.front().record : RayRecord{};
  }

  // What the stage's record over random surfaces breaks of the rules, with endless and with thin columns.
  [[nodiscard]] std::string overSurfaces(const std::string& stage, const std::string& shader,
                                         TraceParameters parameters, const MarchRules& rules) {
    // Bisections of a step that ends at a block's edge all end there, where rounding decides.
    const Job job = rules.bisections > 0 ? randomTerrain(kBlocksSize) : randomBlocks(kBlocksSize);
    for (const double thickness_m : {std::numeric_limits<double>::infinity(), 0.4}) {
      parameters.thickness_m = thickness_m;
      const RayRecord record = trace(job, stage, parameters, shader);
      const std::string difference = differenceFromRules(job, parameters, rules, record, 0.25);
      if (!difference.empty()) {
        return fmt::format("thickness {}, stride {}, {} bisections: {}", thickness_m, parameters.stride_px,
                           parameters.bisection_count, difference);
      }
    }
    return "";
  }
};

NextSigma everyPixels(double stride) {
  return [stride](const MarchRay& ray, int count, const MarchSample&) {
    return count * stride / ray.px_per_sigma;
  };
}

TEST_P(TracersTest, HomogeneousStepsAreExactlyNPixelsLong) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const int stride : {1, 3, 4, 7, 8, 16}) {
      // More than the stride has factors of two would look at texels' edges, where rounding decides.
      for (const int bisections : {0, std::countr_zero(static_cast<unsigned>(stride))}) {
        const std::string difference =
            overSurfaces("homogeneous", shader, {.bisection_count = bisections, .stride_px = stride},
                         {.next = everyPixels(stride), .bisections = bisections});
        if (!difference.empty()) {
          return difference;
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "trace_homogeneous.frag",
                {"homogeneous_z_for_w", "homogeneous_step_denominator", "homogeneous_step_scaled",
                 "homogeneous_offscreen_refined"});
}

// A level floor mirrors; above it is nothing, or a wall that does not mirror.
TEST_P(TracersTest, PixelsWithoutARaySayWhy) {
  for (const bool has_wall : {false, true}) {
    const double wall_m = has_wall ? 8.0 : std::numeric_limits<double>::infinity();
    const RayRecord record = trace(floorAndWall(kFloorSize, wall_m), "walk", {}, "");
    for (int x = 0; x < kFloorSize.width; ++x) {
      const RayHit& above = record.at(x, kFloorSize.height / 4);
      EXPECT_EQ(above.ray_class, has_wall ? RayClass::kMasked : RayClass::kBackground) << x;
      EXPECT_EQ(above.lookups, 0U) << x;
      EXPECT_EQ(above.texel_x, -1) << x;
      EXPECT_GT(record.at(x, kFloorSize.height - 1).lookups, 0U) << x;
    }
  }
}

// Every ray meets the wall between two samples, and with dither by a whole step the part of the step that it
// is behind the wall is anything from nothing to all, of neighbours too: mean 1/2, variance 1/12.
TEST_P(TracersTest, DitherMovesTheSamplesOfNeighboursApart) {
  constexpr int kStridePx = 16;
  const RayRecord record = trace(floorAndWall(kFloorSize, 8.0), "homogeneous",
                                 {.bisection_count = 0, .stride_px = kStridePx, .jitter = 1.0}, "");
  int rows = 0;
  for (int y = 0; y < kFloorSize.height; ++y) {
    double sum = 0.0;
    double squares = 0.0;
    for (int x = 0; x < kFloorSize.width; ++x) {
      const RayHit& ray = record.at(x, y);
      if (ray.ray_class != RayClass::kHit) {
        break;
      }
      // Row y mirrors at the wall's foot, px_y 160, into 320 - (y + 0.5); what lies behind it is higher up.
      const double behind = (319.5 - y - static_cast<double>(ray.px_y)) / kStridePx;
      sum += behind / kFloorSize.width;
      squares += behind * behind / kFloorSize.width;
      rows += x + 1 == kFloorSize.width ? 1 : 0;
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
TEST_P(TracersTest, HomogeneousStepsEndBeforeTheVanishingPoint) {
  const auto check = [&](const std::string& shader) -> std::string {
    const Job job = floorAndWall(kFloorSize, std::numeric_limits<double>::infinity());
    for (const int stride : {1, 4, 10, 33}) {
      const RayRecord record = trace(job, "homogeneous", {.stride_px = stride}, shader);
      for (int y = kFloorSize.height / 2; y < kFloorSize.height; ++y) {
        const double to_vanishing_px = 2.0 * (y + 0.5) - kFloorSize.height;
        const double samples =
            std::ceil(to_vanishing_px * to_vanishing_px / (to_vanishing_px + 0.5) / stride);
        for (int x = 0; x < kFloorSize.width; ++x) {
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

TEST_P(TracersTest, StridedDdaLooksEveryStrideAndBisectsIt) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const int stride : {2, 8, 32}) {
      for (const int bisections : {0, std::countr_zero(static_cast<unsigned>(stride))}) {
        const std::string difference =
            overSurfaces("dda", shader, {.bisection_count = bisections, .stride_px = stride},
                         {.next = everyPixels(stride), .bisections = bisections, .ends_by_metres = false});
        if (!difference.empty()) {
          return difference;
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "trace_dda.frag", {"strided_interval_unordered"});
}

TEST_P(TracersTest, CappedSpreadsItsSamplesOverTheRay) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const int cap : {1, 5, 64}) {
      for (const int bisections : {0, 2, 5}) {
        const auto next = [cap](const MarchRay& ray, int count, const MarchSample&) {
          const double length_px = ray.sigma_end * ray.px_per_sigma;
          const double samples = std::clamp(std::ceil(length_px / 2.0), 1.0, static_cast<double>(cap));
          if (std::abs(length_px / 2.0 - std::round(length_px / 2.0)) < 1e-4) {
            return std::numeric_limits<double>::quiet_NaN();
          }
          return count == samples ? ray.sigma_end : count * ray.sigma_end / samples;
        };
        const std::string difference =
            overSurfaces("capped", shader, {.step_count = cap, .bisection_count = bisections, .stride_px = 2},
                         {.next = next,
                          .bisections = bisections,
                          .ends_by_metres = false,
                          .least_samples = 1,
                          .most_samples = cap});
        if (!difference.empty()) {
          return fmt::format("cap {}: {}", cap, difference);
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "trace_capped.frag", {"capped_not_a_bisection", "capped_stale_distance"});
}

TEST_P(TracersTest, ExponentialStepsGrowAndCoverTheRay) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const double growth : {1.05, 1.5}) {
      for (const int bisections : {0, 2}) {
        constexpr int kSteps = 16;
        const auto next = [growth](const MarchRay& ray, int count, const MarchSample&) {
          const double share = (std::pow(growth, count) - 1.0) / (std::pow(growth, kSteps) - 1.0);
          return count == kSteps ? ray.sigma_end : ray.sigmaAtMetres(share * ray.metresAt(ray.sigma_end));
        };
        const std::string difference =
            overSurfaces("exponential", shader,
                         {.max_distance_m = 30.0,
                          .step_count = kSteps,
                          .bisection_count = bisections,
                          .step_growth = growth},
                         {.next = next, .bisections = bisections, .bisects_metres = true});
        if (!difference.empty()) {
          return difference;
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "trace_exponential.frag", {"exponential_first_step_equal"});
}

TEST_P(TracersTest, AdaptiveStepsFollowTheDepthDifference) {
  constexpr double kBase = 0.05;
  constexpr double kGrowth = 2.0;
  double step_m = 0.0;
  double t_m = 0.0;
  const auto next = [&](const MarchRay& ray, int count, const MarchSample& last) {
    step_m =
        count == 1 ? kBase : std::max(kBase, std::min(last.dist_surface - last.dist_ray, kGrowth * step_m));
    t_m = count == 1 ? step_m : t_m + step_m;
    const double end_m = ray.metresAt(ray.sigma_end);
    if (std::abs(end_m - t_m) < 0.002 * step_m) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return t_m >= end_m ? ray.sigma_end : ray.sigmaAtMetres(t_m);
  };
  const auto check = [&](const std::string& shader) -> std::string {
    for (const int bisections : {0, 2}) {
      const std::string difference = overSurfaces(
          "adaptive", shader,
          {.max_distance_m = 30.0, .step_m = kBase, .bisection_count = bisections, .step_growth = kGrowth},
          {.next = next, .bisections = bisections, .bisects_metres = true});
      if (!difference.empty()) {
        return difference;
      }
    }
    return "";
  };
  holdsAndKills(check, "trace_adaptive.frag", {"adaptive_never_shortens"});
}

// Where the camera's matrix only exchanges and turns axes it rounds nothing, and the world's march is the
// naive one.
TEST_P(TracersTest, TheWorldsMarchIsTheNaiveOneBitForBitUnderAnExactMatrix) {
  Job job = randomBlocks(kBlocksSize);
  const RayRecord naive = trace(job, "naive", {.thickness_m = 0.4}, "");
  for (const glm::dmat4& turned :
       {glm::dmat4(1.0), glm::dmat4({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1})}) {
    job.gbuffer_camera->view_from_world = turned;
    const RayRecord world = trace(job, "world", {.thickness_m = 0.4}, "");
    ASSERT_EQ(world.rays.size(), naive.rays.size());
    EXPECT_EQ(std::memcmp(world.rays.data(), naive.rays.data(), naive.rays.size() * sizeof(RayHit)), 0);
  }
}

// Rounding grows with the distance from the world's origin: 2^-24 of it, over the texel's size at the
// surface.
TEST_P(TracersTest, TheWorldsMarchScattersWithTheDistanceFromTheWorldsOrigin) {
  Job job = randomBlocks(kBlocksSize);
  const RayRecord naive = trace(job, "naive", {.thickness_m = 0.4}, "");
  const auto others = [&](double shift_m) {
    job.gbuffer_camera->view_from_world =
        glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.36, 0.48, 0.8)) *
        glm::translate(glm::dmat4(1.0), glm::dvec3(shift_m, 0.3 * shift_m, -shift_m));
    const RayRecord world = trace(job, "world", {.thickness_m = 0.4}, "");
    int different = 0;
    for (std::size_t i = 0; i < naive.rays.size(); ++i) {
      const RayHit& a = naive.rays[i];
      const RayHit& b = world.rays[i];
      different += std::tie(a.ray_class, a.texel_x, a.texel_y) != std::tie(b.ray_class, b.texel_x, b.texel_y);
    }
    return different;
  };
  const int rays = kBlocksSize.width * kBlocksSize.height;
  EXPECT_LE(others(1.0), rays / 500);
  EXPECT_GE(others(1e5), rays / 20);
}

// The fourth channel of normal_view is the cosine between the ray and the surface's own normal: a shading
// normal may send a ray below the surface although it lies on its own side.
TEST_P(TracersTest, ABentNormalSendsNoRayThroughItsSurface) {
  Job job = floorAndWall(kBlocksSize, 4.0);
  Image& normal = job.gbuffer.at("normal_view");
  Image bent(normal.size, {"R", "G", "B", "A"});
  for (int y = 0; y < normal.size.height; ++y) {
    for (int x = 0; x < normal.size.width; ++x) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        bent.at(x, y, channel) = normal.at(x, y, channel);
      }
      bent.at(x, y, 3) = x % 2 == 0 ? 0.5F : -0.1F;
    }
  }
  normal = bent;
  for (const std::string stage : {"naive", "refined", "dda", "hiz", "walk"}) {
    const RayRecord record = trace(job, stage, {}, "");
    const int y = kBlocksSize.height - 1;  // of the floor
    for (int x = 0; x < kBlocksSize.width; ++x) {
      const RayHit& ray = record.at(x, y);
      EXPECT_EQ(ray.ray_class == RayClass::kIntoSurface, x % 2 == 1) << stage << " " << name(ray.ray_class);
      EXPECT_TRUE(x % 2 == 0 || ray.lookups == 0) << stage;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, TracersTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
