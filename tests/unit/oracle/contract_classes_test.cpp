// The tracing contract: how rays end that hit nothing, and where they begin.
#include <gtest/gtest.h>

#include <cmath>

#include "analytic_scene.h"
#include "contract_rays.h"

namespace ssrkit::testing {

namespace {

void expectNoHit(const RayHit& hit) {
  EXPECT_EQ(hit.texel_x, -1);
  EXPECT_EQ(hit.texel_y, -1);
  EXPECT_EQ(hit.px_x, -1.0F);
  EXPECT_EQ(hit.px_y, -1.0F);
  EXPECT_EQ(hit.t_m, -1.0F);
}

}  // namespace

TEST(OracleContract, BackgroundGoesBeforeTheMaskAndNeitherCostsALookup) {
  AnalyticScene scene = flatScene({3, 1});
  scene.dist_view.at(0, 0) = std::numeric_limits<float>::infinity();
  scene.mask.at(0, 0) = 0.0F;
  scene.mask.at(1, 0) = 0.0F;
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(0, 0).ray_class, RayClass::kBackground);
  EXPECT_EQ(result.record.at(1, 0).ray_class, RayClass::kMasked);
  EXPECT_EQ(result.record.at(0, 0).lookups + result.record.at(1, 0).lookups, 0U);
  expectNoHit(result.record.at(0, 0));
  expectNoHit(result.record.at(1, 0));
}

TEST(OracleContract, WithoutAMaskEveryPixelReflects) {
  AnalyticScene scene = flatScene({9, 9});
  scene.mask.at(4, 0) = 0.0F;
  OracleInput input = scene.input();
  input.mask = nullptr;
  EXPECT_EQ(traceOracle(input)->record.at(4, 0).ray_class, RayClass::kOffscreen);
}

TEST(OracleContract, ANegativeFourthChannelOrANormalTurnedAwayIsIntoSurface) {
  AnalyticScene scene = flatScene({3, 1});
  setNormal(scene, 0, 0, {0, 0, 1}, -0.01F);
  setNormal(scene, 1, 0, {0.1, 0, -1});
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(0, 0).ray_class, RayClass::kIntoSurface);
  EXPECT_EQ(result.record.at(1, 0).ray_class, RayClass::kIntoSurface);
  EXPECT_EQ(result.record.at(0, 0).lookups, 0U);
  expectNoHit(result.record.at(1, 0));
}

TEST(OracleContract, ARayStraightBackAtTheCameraStaysInItsTexelAndEndsAtTheNearPlane) {
  const OracleResult result = trace(frontalMirrorAt10({5, 5}));
  EXPECT_EQ(result.record.at(2, 2).ray_class, RayClass::kOffscreen);
  EXPECT_EQ(result.record.at(2, 2).lookups, 0U);
}

TEST(OracleContract, ARayStraightBackAtTheCameraEndsAsRangeWhenThatComesFirst) {
  TraceParameters parameters;
  parameters.max_distance_m = 9.0;
  const OracleResult result = trace(frontalMirrorAt10({5, 5}), parameters);
  EXPECT_EQ(result.record.at(2, 2).ray_class, RayClass::kRange);
  EXPECT_EQ(result.record.at(2, 2).lookups, 0U);
}

TEST(OracleContract, ARayStraightAwayFromTheCameraStaysInItsTexelAndEndsAsRange) {
  AnalyticScene scene = flatScene({5, 5});
  setNormal(scene, 2, 2, {0, 1, 0});  // edge-on: the ray passes through unbent
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(2, 2).ray_class, RayClass::kRange);
  EXPECT_EQ(result.record.at(2, 2).lookups, 0U);
}

TEST(OracleContract, ARayThatReachesTheNearPlaneInsideTheImageIsOffscreen) {
  // One texel right of the centre: seen at 1 * (20 - .1) / .1 = 199 texels when it meets near_m = .1.
  const AnalyticScene scene = frontalMirrorAt10({501, 3});
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(251, 1).ray_class, RayClass::kOffscreen);
  EXPECT_EQ(result.record.at(251, 1).lookups, 198U);
  EXPECT_EQ(result.record.at(249, 1).lookups, 198U);
  // Two texels: it leaves the image 250.5 texels from the centre first.
  EXPECT_EQ(result.record.at(252, 1).lookups, 248U);
}

TEST(OracleContract, MaxDistanceEndsARayInTheMiddleOfATexelAsRange) {
  // Seen at 10 (20 - dist) / dist: 15 texels from the centre at dist 8, 2 m nearer.
  const AnalyticScene scene = frontalMirrorAt10({201, 201});
  TraceParameters parameters;
  const double tangent = 20.0 / 201.0 / 2.0;
  parameters.max_distance_m = 2.0 * std::sqrt(1.0 + tangent * tangent);
  const OracleResult result = trace(scene, parameters);
  const RayHit& ray = result.record.at(110, 100);
  EXPECT_EQ(ray.ray_class, RayClass::kRange);
  EXPECT_EQ(ray.lookups, 5U);
  expectNoHit(ray);
}

TEST(OracleContract, AnInfiniteRayThatApproachesItsVanishingPointEndsAsRange) {
  AnalyticScene scene = sceneM1({64, 64});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 64; ++x) {
      scene.dist_view.at(x, y) = std::numeric_limits<float>::infinity();
    }
  }
  const OracleResult result = trace(scene);
  // The vanishing point of row 50 is its mirror image about the horizon, row 13.
  EXPECT_EQ(result.record.at(20, 50).ray_class, RayClass::kRange);
  EXPECT_EQ(result.record.at(20, 50).lookups, 37U);
}

TEST(OracleContract, AColumnThatHoldsTheRayAlreadyIsHitWhereTheRayEntersTheTexel) {
  AnalyticScene scene = frontalMirrorAt10({201, 201});
  scene.dist_view.at(119, 100) = 6.0F;
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(110, 100).texel_x, 119);
  EXPECT_FLOAT_EQ(result.record.at(110, 100).px_x, 119.0F);
}

TEST(OracleContract, ABudgetBindsExactlyTheRaysThatNeedMore) {
  const AnalyticScene scene = sceneM3({32, 64});
  TraceParameters parameters;
  parameters.thickness_m = 1.0;
  const OracleResult free = trace(scene, parameters);
  for (int budget = 0; budget < 90; ++budget) {
    parameters.lookup_budget = budget;
    const OracleResult bound = trace(scene, parameters);
    for (std::size_t i = 0; i < free.record.rays.size(); ++i) {
      const RayHit& unlimited = free.record.rays[i];
      if (unlimited.lookups <= static_cast<std::uint32_t>(budget)) {
        expectSameRay(bound.record.rays[i], unlimited);
      } else {
        EXPECT_EQ(bound.record.rays[i].ray_class, RayClass::kBudget);
        EXPECT_EQ(bound.record.rays[i].lookups, static_cast<std::uint32_t>(budget));
        expectNoHit(bound.record.rays[i]);
      }
    }
  }
}

TEST(OracleContract, ASinglePixelHasNobodyToHit) {
  const OracleResult result = trace(flatScene({1, 1}));
  ASSERT_EQ(result.record.rays.size(), 1U);
  EXPECT_EQ(result.record.at(0, 0).ray_class, RayClass::kOffscreen);
  EXPECT_EQ(result.record.at(0, 0).lookups, 0U);
}

TEST(OracleContract, APixelNearerThanTheNearPlaneIsOffscreenWithoutALookup) {
  AnalyticScene scene = flatScene({9, 9});
  scene.dist_view.at(6, 4) = 0.05F;
  scene.dist_view.at(7, 4) = -1.0F;
  const OracleResult result = trace(scene);
  for (const int x : {6, 7}) {
    EXPECT_EQ(result.record.at(x, 4).ray_class, RayClass::kOffscreen);
    EXPECT_EQ(result.record.at(x, 4).lookups, 0U);
  }
}

TEST(OracleContract, ThatHoldsForARayThatMovesAwayFromTheCameraToo) {
  AnalyticScene scene = sceneM1({32, 64});
  ASSERT_EQ(trace(scene).record.at(20, 60).ray_class, RayClass::kHit);
  scene.dist_view.at(20, 60) = 0.05F;
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(20, 60).ray_class, RayClass::kOffscreen);
  EXPECT_EQ(result.record.at(20, 60).lookups, 0U);
}

TEST(OracleContract, ABiasMovesTheOriginAlongTheNormalByAFractionOfItsDistance) {
  // Frontal mirror at 5, bias .1: the ray of pixel 110, 10 texels from the centre, starts at dist 4.5. It
  // moves in x as if it went on behind the mirror: seen at 10 (9.5 - dist) / dist.
  AnalyticScene scene = flatScene({201, 201});
  scene.dist_view.at(140, 100) = 1.5F;
  TraceParameters parameters;
  parameters.origin_bias = 0.1;
  const RayHit hit = trace(scene, parameters).record.at(110, 100);
  // Texel 140 begins 39.5 away, at dist 95 / 49.5.
  const double dist = 95.0 / 49.5;
  const double tangent = 20.0 / 201.0 / 2.0;
  ASSERT_EQ(hit.ray_class, RayClass::kHit);
  EXPECT_EQ(hit.texel_x, 140);
  EXPECT_FLOAT_EQ(hit.t_m, static_cast<float>((4.5 - dist) * std::sqrt(1.0 + tangent * tangent)));
  // The origin is seen 11.1 texels from the centre, in texel 111: that one is tested too, and 110 never.
  EXPECT_EQ(hit.lookups, 30U);
}

TEST(OracleContract, ABiasThatPushesTheOriginOutOfTheImageIsOffscreen) {
  AnalyticScene scene = flatScene({9, 9});
  setNormal(scene, 0, 4, {-0.9, 0.0, 0.4});
  TraceParameters parameters;
  parameters.origin_bias = 0.5;
  const OracleResult result = trace(scene, parameters);
  EXPECT_EQ(result.record.at(0, 4).ray_class, RayClass::kOffscreen);
  EXPECT_EQ(result.record.at(0, 4).lookups, 0U);
}

}  // namespace ssrkit::testing
