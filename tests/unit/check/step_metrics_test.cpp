// Hits held against the steps that found them: over a floor before a wall, whose oracle is the real one.
#include <gtest/gtest.h>

#include <cmath>

#include "check/march_samples.h"
#include "check/march_step.h"
#include "made_answers.h"
#include "oracle/image_ray.h"

namespace ssrkit {
namespace {

constexpr Size kFloorSize{32, 32};
constexpr float kWall = 4.0F;
constexpr int kStepCount = 16;

const char* const kInStep = "metric = \"hit_in_step_share\"\nmin = 0.95\nallow_empty = true";
const char* const kOffRay = "metric = \"hit_off_ray_share\"\nmax = 0\nallow_empty = true";

// A mirror floor one metre below the camera, and a wall; the stage says what the oracle says until a test
// changes it.
struct OverFloor : Bench {
  explicit OverFloor(const std::string& stage = "naive", double thickness_m = 1e9,
                     int rows = kFloorSize.height) {
    Answer& answer = add(stage, RayRecord{kFloorSize, std::vector<RayHit>(1024)});
    OracleInput& input = setWorld(answer, kWall);
    Image& normals = images.back();
    Image& depth = images[images.size() - 2];
    Image& mask = images.emplace_back(kFloorSize, std::vector<std::string>{"mask"});
    for (int y = 0; y < kFloorSize.height; ++y) {
      const float floor_dist = 1.0F / (2.0F * (static_cast<float>(y) + 0.5F) / 32.0F - 1.0F);
      for (int x = 0; x < kFloorSize.width && floor_dist > 0.0F && floor_dist < kWall; ++x) {
        depth.at(x, y, 0) = floor_dist;
        normals.at(x, y, 1) = 1.0F;
        normals.at(x, y, 2) = 0.0F;
        mask.at(x, y, 0) = y >= kFloorSize.height - rows ? 1.0F : 0.0F;
      }
    }
    input.mask = &mask;
    input.parameters.thickness_m = thickness_m;
    answer.parameters = input.parameters;
    answer.parameters.step_count = kStepCount;
    answer.parameters.bisection_count = 0;
    const auto truth = traceOracle(input, 1);
    EXPECT_TRUE(truth.has_value());
    records.front() = truth->record;
    oracles.push_back(*truth);
    answer.oracle = &oracles.back();
  }

  // Moves every hit along its ray by a share of its step.
  void moveHits(double share) {
    const OracleInput& input = inputs.front();
    const PixelProjection projection = pixelProjection(*input.camera);
    for (int y = 0; y < kFloorSize.height; ++y) {
      for (int x = 0; x < kFloorSize.width; ++x) {
        RayHit& hit = records.front().rays[static_cast<std::size_t>(y * kFloorSize.width + x)];
        if (hit.ray_class != RayClass::kHit) {
          continue;
        }
        const ImageRay ray = pixelRay(input, projection, x, y).ray;
        const double t_m = hit.t_m + share * lengthMetres(ray) / kStepCount;
        const glm::dvec2 px = ray.pxAt(sigmaAtMetres(ray, t_m));
        hit.t_m = static_cast<float>(t_m);
        hit.px_x = static_cast<float>(px.x);
        hit.px_y = static_cast<float>(px.y);
        hit.texel_x = static_cast<int>(px.x);
        hit.texel_y = static_cast<int>(px.y);
      }
    }
  }

  void missAll() {
    for (RayHit& hit : records.front().rays) {
      hit = hit.ray_class == RayClass::kHit ? without(RayClass::kOffscreen) : hit;
    }
  }
};

TEST(HitInStepShare, WhatTheOracleSaysPassesAndNoHitAtAllFails) {
  OverFloor bench;
  EXPECT_EQ(bench.check(expectation(kInStep)).value, 1.0);
  EXPECT_EQ(outcomeName(bench.check(expectation(kInStep))), "pass");
  bench.missAll();
  const CheckResult missed = bench.check(expectation(kInStep));
  EXPECT_EQ(outcomeName(missed), "fail");
  EXPECT_NE(missed.message.find("[never-hits]"), std::string::npos) << missed.message;
}

TEST(HitInStepShare, AHitBehindTheTrueOneMayBeAStepAwayAndNotThree) {
  OverFloor bench;
  bench.moveHits(0.9);
  EXPECT_EQ(outcomeName(bench.check(expectation(kInStep))), "pass");
  bench.moveHits(2.1);
  EXPECT_EQ(outcomeName(bench.check(expectation(kInStep))), "fail");
}

// A step reaches further than the column is thick, so a march that looks at points finds it by chance; one
// that holds the step's depths against the column does not.
TEST(HitInStepShare, WhatIsThinnerThanAStepMayBeLostByPointsAlone) {
  OverFloor points("naive", 0.001);
  points.missAll();
  EXPECT_EQ(outcomeName(points.check(expectation(kInStep))), "pass");
  OverFloor intervals("refined", 0.001);
  intervals.missAll();
  EXPECT_EQ(outcomeName(intervals.check(expectation(kInStep))), "fail");
}

TEST(HitInStepShare, AShareOfFewHitsIsNotAsked) {
  OverFloor bench("naive", 1e9, 1);
  bench.missAll();
  EXPECT_EQ(outcomeName(bench.check(expectation(kInStep))), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"hit_in_step_share\"\nmin = 0.95"))), "fail");
}

TEST(HitOffRayShare, AHitAsideOfItsRayOrInAnotherColumnFails) {
  OverFloor bench;
  bench.moveHits(0.5);
  EXPECT_EQ(outcomeName(bench.check(expectation(kOffRay))), "pass");
  OverFloor aside;
  for (RayHit& hit : aside.records.front().rays) {
    hit.texel_x += hit.ray_class == RayClass::kHit ? 1 : 0;
    hit.px_x += hit.ray_class == RayClass::kHit ? 1.0F : 0.0F;
  }
  EXPECT_EQ(outcomeName(aside.check(expectation(kOffRay))), "fail");
  OverFloor before_the_wall;
  before_the_wall.moveHits(-0.5);
  EXPECT_EQ(outcomeName(before_the_wall.check(expectation(kOffRay))), "fail");
  OverFloor behind_thin_ones("naive", 0.001);
  behind_thin_ones.moveHits(0.9);
  EXPECT_EQ(outcomeName(behind_thin_ones.check(expectation(kOffRay))), "fail");
}

TEST(HitOffRayShare, AStageWithoutStepsIsAnError) {
  OverFloor bench("hiz");
  EXPECT_EQ(outcomeName(bench.check(expectation(kOffRay))), "error");
  bench.answers.front().stage = "dda_8_4";
  EXPECT_EQ(outcomeName(bench.check(expectation(kOffRay))), "pass");
  bench.answers.front().oracle = nullptr;
  EXPECT_EQ(outcomeName(bench.check(expectation(kOffRay))), "error");
}

// The steps of a ray, by a sum: n of them, each `growth` times the one before, make the length.
TEST(MarchStep, GrowingStepsAreTheOnesOfTheirSum) {
  ImageRay ray;
  ray.inv_dist_origin = 0.5;
  ray.px_per_sigma = {3.0, 4.0};
  ray.sigma_end = 5.0;  // 10 m along, at constant depth
  const TraceParameters grown{.step_count = 3, .step_growth = 2.0};
  const auto endOf = [&](double t_m) {
    return ray.tMetresAt(stepEnd(StepKind::kExponential, ray, grown, sigmaAtMetres(ray, t_m)));
  };
  EXPECT_NEAR(endOf(0.0), 10.0 / 7.0, 1e-12);
  EXPECT_NEAR(endOf(10.0 / 7.0), 30.0 / 7.0, 1e-12);
  EXPECT_TRUE(std::isinf(stepEnd(StepKind::kExponential, ray, grown, sigmaAtMetres(ray, 4.5))));
}

TEST(MarchStep, StridesCountAlongTheLongerAxisAndACapSpreadsThem) {
  ImageRay ray;
  ray.inv_dist_origin = 0.5;
  ray.px_per_sigma = {3.0, 4.0};
  ray.sigma_end = 5.0;  // 20 px along y
  const TraceParameters parameters{.step_count = 4, .stride_px = 2};
  EXPECT_NEAR(stepStart(StepKind::kPixels, ray, parameters, 2.0), 1.5, 1e-12);
  EXPECT_NEAR(stepStart(StepKind::kCapped, ray, parameters, 2.0), 0.75, 1e-12);
  EXPECT_EQ(stepStart(StepKind::kPixels, ray, parameters, 0.25), 0.0);
  EXPECT_EQ(stepKind("dda_32_4_dither"), StepKind::kPixels);
  EXPECT_EQ(stepKind("walk"), std::nullopt);
}

}  // namespace
}  // namespace ssrkit
