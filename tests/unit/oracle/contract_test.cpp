// The tracing contract, a sentence at a time, on G-buffers made by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analytic_scene.h"

namespace ssrkit::testing {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void setNormal(AnalyticScene& scene, int x, int y, glm::dvec3 normal, float cosine = 1.0F) {
  for (int axis = 0; axis < 3; ++axis) {
    scene.normal_view.at(x, y, static_cast<std::size_t>(axis)) = static_cast<float>(normal[axis]);
  }
  scene.normal_view.at(x, y, 3) = cosine;
}

// A frontal mirror at dist_view 10: the ray of a pixel d texels right of the centre is seen at d (20 - dist)
// / dist.
AnalyticScene frontalMirrorAt10(Size size) {
  return render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
}

void expectNoHit(const RayHit& hit) {
  EXPECT_EQ(hit.texel_x, -1);
  EXPECT_EQ(hit.texel_y, -1);
  EXPECT_EQ(hit.px_x, -1.0F);
  EXPECT_EQ(hit.px_y, -1.0F);
  EXPECT_EQ(hit.t_m, -1.0F);
}

void expectSameRay(const RayHit& a, const RayHit& b) {
  EXPECT_EQ(a.ray_class, b.ray_class);
  EXPECT_EQ(a.texel_x, b.texel_x);
  EXPECT_EQ(a.texel_y, b.texel_y);
  EXPECT_EQ(a.px_x, b.px_x);
  EXPECT_EQ(a.px_y, b.px_y);
  EXPECT_EQ(a.t_m, b.t_m);
  EXPECT_EQ(a.lookups, b.lookups);
  EXPECT_EQ(a.steps, b.steps);
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

TEST(OracleContract, ThreeChannelNormalsGiveTheSameRays) {
  AnalyticScene scene = sceneM2({33, 21});
  const OracleResult with_four = trace(scene);
  Image three({33, 21}, {"X", "Y", "Z"});
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 33; ++x) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        three.at(x, y, axis) = scene.normal_view.at(x, y, axis);
      }
    }
  }
  scene.normal_view = three;
  const OracleResult with_three = trace(scene);
  for (std::size_t i = 0; i < with_four.record.rays.size(); ++i) {
    expectSameRay(with_four.record.rays[i], with_three.record.rays[i]);
  }
}

TEST(OracleContract, OneMirrorPlaneOfAnyOrientationNeverHitsItself) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int rays = 0;
  for (int plane = 0; plane < 60; ++plane) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(unit(random), unit(random), unit(random)));
    const glm::dvec3 point(unit(random), unit(random), -4.0 + 3.0 * unit(random));
    const AnalyticScene scene =
        render(formulaCamera({67, 59}),
               {{.normal_view = normal, .offset = glm::dot(normal, point), .is_mirror = true}});
    const OracleResult result = trace(scene);
    for (const RayHit& hit : result.record.rays) {
      EXPECT_NE(hit.ray_class, RayClass::kHit);
      rays += hit.lookups > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(rays, 60000);
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

TEST(OracleContract, AColumnIsEnteredThroughItsBackByARayThatComesNearer) {
  // Texel 119 is 18.5 to 19.5 texels from the centre: dist 7.0175 to 6.78. The column [6, 7) is entered at 7.
  AnalyticScene scene = frontalMirrorAt10({201, 201});
  scene.dist_view.at(119, 100) = 6.0F;
  TraceParameters parameters;
  parameters.thickness_m = 1.0;
  const double tangent = 20.0 / 201.0 / 2.0;
  const OracleResult result = trace(scene, parameters);
  const RayHit& hit = result.record.at(110, 100);
  ASSERT_EQ(hit.ray_class, RayClass::kHit);
  EXPECT_EQ(hit.texel_x, 119);
  EXPECT_EQ(hit.texel_y, 100);
  EXPECT_FLOAT_EQ(hit.px_x, static_cast<float>(100.5 + 10.0 * 13.0 / 7.0));
  EXPECT_FLOAT_EQ(hit.px_y, 100.5F);
  EXPECT_FLOAT_EQ(hit.t_m, static_cast<float>(3.0 * std::sqrt(1.0 + tangent * tangent)));
  EXPECT_EQ(hit.lookups, 9U);
}

TEST(OracleContract, AColumnThatHoldsTheRayAlreadyIsHitWhereTheRayEntersTheTexel) {
  AnalyticScene scene = frontalMirrorAt10({201, 201});
  scene.dist_view.at(119, 100) = 6.0F;
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(110, 100).texel_x, 119);
  EXPECT_FLOAT_EQ(result.record.at(110, 100).px_x, 119.0F);
}

TEST(OracleContract, ARayBehindAColumnByMoreThanItsThicknessPassesOn) {
  AnalyticScene scene = frontalMirrorAt10({201, 201});
  scene.dist_view.at(119, 100) = 6.0F;
  TraceParameters parameters;
  parameters.thickness_m = 0.75;
  const OracleResult result = trace(scene, parameters);
  EXPECT_EQ(result.record.at(110, 100).ray_class, RayClass::kOffscreen);
  parameters.thickness_rel = 0.0417;  // 6 * .0417 = .2502 more
  EXPECT_EQ(trace(scene, parameters).record.at(110, 100).ray_class, RayClass::kHit);
}

TEST(OracleContract, BackgroundColumnsAreNeverHit) {
  AnalyticScene scene = frontalMirrorAt10({33, 33});
  for (int x = 0; x < 33; ++x) {
    scene.dist_view.at(x, 20) = std::numeric_limits<float>::infinity();
  }
  for (const RayHit& hit : trace(scene).record.rays) {
    EXPECT_NE(hit.ray_class, RayClass::kHit);
  }
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

TEST(OracleContract, NanInTheImagesHitsNothingAndStopsNothing) {
  AnalyticScene scene = sceneM1({32, 32});
  for (int y = 0; y < 20; ++y) {
    scene.dist_view.at(5, y) = kNan;
  }
  scene.normal_view.at(6, 30, 1) = kNan;
  setNormal(scene, 7, 30, {0, 0, 0});
  const OracleResult result = trace(scene);
  EXPECT_EQ(result.record.at(5, 0).ray_class, RayClass::kBackground);
  EXPECT_EQ(result.record.at(5, 30).ray_class, RayClass::kRange);
  EXPECT_EQ(result.record.at(6, 30).ray_class, RayClass::kIntoSurface);
  EXPECT_EQ(result.record.at(7, 30).ray_class, RayClass::kIntoSurface);
  EXPECT_EQ(result.record.at(8, 30).ray_class, RayClass::kHit);
}

TEST(OracleContract, AMirroredSceneMirrorsTheRecord) {
  const AnalyticScene scene = sceneM4({61, 37});
  AnalyticScene mirrored = scene;
  for (int y = 0; y < 37; ++y) {
    for (int x = 0; x < 61; ++x) {
      mirrored.dist_view.at(x, y) = scene.dist_view.at(60 - x, y);
      mirrored.mask.at(x, y) = scene.mask.at(60 - x, y);
      for (std::size_t channel = 0; channel < 4; ++channel) {
        mirrored.normal_view.at(x, y, channel) = scene.normal_view.at(60 - x, y, channel);
      }
      mirrored.normal_view.at(x, y, 0) *= -1.0F;
    }
  }
  const OracleResult a = trace(scene);
  const OracleResult b = trace(mirrored);
  int hits = 0;
  for (int y = 0; y < 37; ++y) {
    for (int x = 0; x < 61; ++x) {
      const RayHit& left = a.record.at(x, y);
      RayHit right = b.record.at(60 - x, y);
      if (right.ray_class == RayClass::kHit) {
        ++hits;
        right.texel_x = 60 - right.texel_x;
        EXPECT_NEAR(61.0F - right.px_x, left.px_x, 1e-5F);
        right.px_x = left.px_x;
      }
      expectSameRay(left, right);
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(OracleContract, AWorldOfTwiceTheSizeChangesNothingButMetres) {
  const AnalyticScene scene = sceneM3({48, 64});
  AnalyticScene large = scene;
  large.camera.near_m *= 2.0;
  for (float& dist : large.dist_view.data) {
    dist *= 2.0F;
  }
  TraceParameters parameters;
  parameters.thickness_m = 1.0;
  parameters.max_distance_m = 12.0;
  TraceParameters large_parameters = parameters;
  large_parameters.thickness_m *= 2.0;
  large_parameters.max_distance_m *= 2.0;
  const OracleResult a = trace(scene, parameters);
  const OracleResult b = trace(large, large_parameters);
  for (std::size_t i = 0; i < a.record.rays.size(); ++i) {
    RayHit expected = a.record.rays[i];
    if (expected.ray_class == RayClass::kHit) {
      expected.t_m *= 2.0F;
    }
    expectSameRay(b.record.rays[i], expected);
  }
}

TEST(OracleContract, TheNumberOfThreadsChangesNothing) {
  const AnalyticScene scene = sceneM2({93, 71});
  const OracleResult one = trace(scene, {}, 1);
  for (const int threads : {0, 2, 3, 8, 500}) {
    const OracleResult many = trace(scene, {}, threads);
    EXPECT_EQ(many.ambiguity, one.ambiguity);
    for (std::size_t i = 0; i < one.record.rays.size(); ++i) {
      expectSameRay(many.record.rays[i], one.record.rays[i]);
    }
  }
}

TEST(OracleCells, TheCellsOfARayAreItsLookupsWithTheHitLast) {
  const AnalyticScene scene = sceneM2({48, 40});
  const OracleInput input = scene.input();
  const OracleResult result = trace(scene);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 48; ++x) {
      const std::vector<WalkCell> cells = cellsOf(input, x, y);
      const RayHit& hit = result.record.at(x, y);
      ASSERT_EQ(cells.size(), hit.lookups);
      int last_x = x;
      int last_y = y;
      for (const WalkCell& cell : cells) {
        EXPECT_EQ(std::abs(cell.x - last_x) + std::abs(cell.y - last_y), 1)
            << "one edge is crossed at a time";
        last_x = cell.x;
        last_y = cell.y;
      }
      if (hit.ray_class == RayClass::kHit) {
        EXPECT_EQ(cells.back().x, hit.texel_x);
        EXPECT_EQ(cells.back().y, hit.texel_y);
      }
    }
  }
}

TEST(OracleCells, InM1TheDistanceAtEveryCellsEdgesIsTheFormulas) {
  // dist = 2hf / (|Y| - Y_edge) on the way up from row 56.
  const AnalyticScene scene = sceneM1({64, 64});
  const std::vector<WalkCell> cells = cellsOf(scene.input(), 9, 56);
  ASSERT_FALSE(cells.empty());
  const double start = 2.0 * 56.5 / 64.0 - 1.0;
  for (const WalkCell& cell : cells) {
    const double lower_edge = 1.0 - 2.0 * (cell.y + 1) / 64.0;
    const double upper_edge = 1.0 - 2.0 * cell.y / 64.0;
    EXPECT_NEAR(cell.dist_in, 4.0 / (start - lower_edge), 1e-6);
    EXPECT_NEAR(cell.dist_out, 4.0 / (start - upper_edge), 1e-6);
  }
}

TEST(OracleCells, ABudgetCutsTheCellsWhereItCutsTheRay) {
  TraceParameters parameters;
  parameters.lookup_budget = 5;
  const AnalyticScene scene = sceneM1({64, 64});
  EXPECT_EQ(cellsOf(scene.input(), 9, 56).size(), 33U);
  EXPECT_EQ(cellsOf(scene.input(parameters), 9, 56).size(), 5U);
}

TEST(OracleCells, PixelsWithoutARayHaveNoCells) {
  const AnalyticScene scene = sceneM1({64, 64});
  EXPECT_TRUE(cellsOf(scene.input(), 9, 3).empty());
}

}  // namespace ssrkit::testing
