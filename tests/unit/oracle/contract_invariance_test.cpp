// What must not change a ray: another layout, a mirrored or larger world, threads; and the list of its cells.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analytic_scene.h"
#include "contract_rays.h"

namespace ssrkit::testing {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

}  // namespace

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
