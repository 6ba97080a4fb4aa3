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
#include "tracer_fixture.h"

namespace ssrkit {
namespace {

const Size kBlocksSize{96, 64};

class TracersTest : public TracerFixture {
 protected:
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

// Steps of one length in metres: of `step_m`, or so that `step_count` of them, a power of two whose multiples
// round to nothing, make the ray.
NextSigma everyMetres(double step_m, int step_count) {
  return [=](const MarchRay& ray, int count, const MarchSample&) {
    if (step_m <= 0.0) {
      const double share = static_cast<double>(count) / step_count;
      return count == step_count ? ray.sigma_end : ray.sigmaAtMetres(share * ray.metresAt(ray.sigma_end));
    }
    const double end_m = ray.metresAt(ray.sigma_end);
    if (std::abs(end_m - count * step_m) < 1e-4 * end_m) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return count * step_m >= end_m ? ray.sigma_end : ray.sigmaAtMetres(count * step_m);
  };
}

TEST_P(TracersTest, NaiveAndWorldLookAtAPointEveryStep) {
  for (const std::string stage : {"naive", "world"}) {
    for (const double step_m : {0.0, 0.07, 0.5}) {
      EXPECT_EQ(overSurfaces(stage, "", {.max_distance_m = 30.0, .step_count = 32, .step_m = step_m},
                             {.next = everyMetres(step_m, 32), .looks_at_points = true}),
                "")
          << stage << ", steps of " << step_m;
    }
  }
}

TEST_P(TracersTest, RefinedTestsEveryStepUpToTheRaysEndAndBisectsIt) {
  for (const double step_m : {0.0, 0.07, 0.5}) {
    for (const int bisections : {0, 2, 4}) {
      EXPECT_EQ(
          overSurfaces(
              "refined", "",
              {.max_distance_m = 30.0, .step_count = 32, .step_m = step_m, .bisection_count = bisections},
              {.next = everyMetres(step_m, 32), .bisections = bisections, .bisects_metres = true}),
          "")
          << "steps of " << step_m;
    }
  }
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
