// The oracle against the formulas, and the formulas against numbers worked out by hand.
#include "oracle/closed_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analytic_scene.h"

namespace ssrkit::testing {

namespace {

struct Agreement {
  int decided = 0;
  int hits = 0;
  int undecided = 0;
};

// Holds every decided pixel of the scene against the oracle's record.
Agreement expectOracleAgrees(const std::string& scene_name, const AnalyticScene& scene,
                             const TraceParameters& parameters = {}) {
  const OracleResult result = trace(scene, parameters);
  const Size size = scene.camera.size;
  Agreement agreement;
  int reported = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const ExpectedRay expected = expectedAt(scene_name, size, parameters, x, y);
      const RayHit& actual = result.record.at(x, y);
      if (!expected.ray_class) {
        ++agreement.undecided;
        EXPECT_FALSE(expected.undecided.empty());
        continue;
      }
      ++agreement.decided;
      agreement.hits += *expected.ray_class == RayClass::kHit ? 1 : 0;
      bool agrees = actual.ray_class == *expected.ray_class && actual.texel_x == expected.texel.x &&
                    actual.texel_y == expected.texel.y;
      if (agrees && expected.lookups >= 0) {
        agrees = static_cast<int>(actual.lookups) == expected.lookups;
      }
      if (agrees && *expected.ray_class == RayClass::kHit) {
        // A float's rounding of dist_view and of the position is all that may differ.
        agrees = std::abs(actual.px_x - expected.px.x) < 2e-3 && std::abs(actual.px_y - expected.px.y) < 2e-3;
      }
      if (!agrees && ++reported <= 5) {
        ADD_FAILURE() << scene_name << " " << size.width << "x" << size.height
                      << " T=" << parameters.thickness_m << " pixel " << x << "," << y << ": expected "
                      << static_cast<int>(*expected.ray_class) << " at " << expected.texel.x << ","
                      << expected.texel.y << " px " << expected.px.x << "," << expected.px.y << " cells "
                      << expected.lookups << ", got " << static_cast<int>(actual.ray_class) << " at "
                      << actual.texel_x << "," << actual.texel_y << " px " << actual.px_x << ","
                      << actual.px_y << " cells " << actual.lookups;
      }
    }
  }
  EXPECT_EQ(reported, 0);
  return agreement;
}

TraceParameters thickness(double thickness_m) {
  TraceParameters parameters;
  parameters.thickness_m = thickness_m;
  return parameters;
}

const std::vector<Size> kSizes = {{256, 256}, {64, 48}, {160, 90}, {127, 63},
                                  {5, 7},     {1, 33},  {3, 3},    {97, 128}};

}  // namespace

TEST(ClosedForm, M1At256MirrorsRow160To255AboutTheContactRow) {
  for (int row = 160; row < 256; ++row) {
    const ExpectedRay ray = expectedAt("m1", {256, 256}, {}, 100, row);
    ASSERT_EQ(ray.ray_class, RayClass::kHit) << row << " " << ray.undecided;
    EXPECT_EQ(ray.texel, (Texel{100, 319 - row}));
    EXPECT_EQ(ray.lookups, 2 * row - 319);
  }
  EXPECT_EQ(expectedAt("m1", {256, 256}, {}, 100, 159).ray_class, RayClass::kMasked);
}

TEST(ClosedForm, M1AtHeightsWhereTheMirrorImageFallsOnARowBorderIsUndecided) {
  // 1.25 H - .5 is whole for H = 4k + 2.
  EXPECT_FALSE(expectedAt("m1", {66, 66}, {}, 3, 60).ray_class);
  EXPECT_TRUE(expectedAt("m1", {66, 64}, {}, 3, 60).ray_class);
}

TEST(OracleClosedForm, OracleGivesTheFormulaOfM1AtEverySize) {
  for (const Size size : kSizes) {
    for (const double thickness_m : {kInfinity, 0.5, 1e-3}) {
      const Agreement agreement = expectOracleAgrees("m1", sceneM1(size), thickness(thickness_m));
      if (size.height % 4 != 2) {
        EXPECT_EQ(agreement.undecided, 0) << size.width << "x" << size.height;
        EXPECT_GT(agreement.hits, 0);
      }
    }
  }
}

TEST(OracleClosedForm, OracleVisits2RowMinus319CellsInM1At256) {
  const OracleResult result = trace(sceneM1({256, 256}));
  for (int row = 160; row < 256; ++row) {
    for (const int column : {0, 77, 255}) {
      EXPECT_EQ(result.record.at(column, row).lookups, static_cast<std::uint32_t>(2 * row - 319));
      EXPECT_EQ(result.record.at(column, row).texel_y, 319 - row);
      EXPECT_EQ(result.record.at(column, row).texel_x, column);
    }
  }
}

TEST(OracleClosedForm, OracleGivesTheFormulaOfM2AtEverySize) {
  for (const Size size : kSizes) {
    for (const double thickness_m : {kInfinity, 1.0}) {
      const Agreement agreement = expectOracleAgrees("m2", sceneM2(size), thickness(thickness_m));
      EXPECT_LT(agreement.undecided, 0.05 * size.width * size.height) << size.width << "x" << size.height;
    }
  }
  // The integral of 4|Y| - 1 over 1/3 < |Y| < 1/2, a ninth of the image's half height and full width.
  EXPECT_NEAR(expectOracleAgrees("m2", sceneM2({256, 256})).hits, 65536.0 / 18.0, 400.0);
}

TEST(OracleClosedForm, TheHandWorkedRayOfM2MeetsTheFloorAt3Metres) {
  // (X, Y) = (.3, -.4): dist 3, seen at (.5, -.6667). 200x200 has a texel centre at .305, -.405.
  const double X = 0.305;
  const double Y = 0.405;
  const double dist = 8.0 - 2.0 / Y;
  const OracleResult result = trace(sceneM2({200, 200}));
  const RayHit& hit = result.record.at(130, 140);
  ASSERT_EQ(hit.ray_class, RayClass::kHit);
  // A column has its centre's depth, so the hit is within one texel of the true point.
  EXPECT_NEAR(hit.px_x, 100.0 * (1.0 + X * (8.0 - dist) / dist), 1.0);
  EXPECT_NEAR(hit.px_y, 100.0 * (1.0 + 2.0 / dist), 1.0);
}

TEST(OracleClosedForm, RaysOfM2AtMinusPoint4LeaveTheImageExactlyBeyondPoint6) {
  // 250 rows: the centre of row 174 is Y = -.396, of row 175 is -.404; |X| < z / (8 - z) there.
  const OracleResult result = trace(sceneM2({250, 250}));
  for (const int row : {174, 175}) {
    const double Y = 1.0 - 2.0 * (row + 0.5) / 250.0;
    const double dist = 8.0 - 2.0 / -Y;
    const double boundary = dist / (8.0 - dist);
    for (int column = 0; column < 250; ++column) {
      const double X = std::abs(2.0 * (column + 0.5) / 250.0 - 1.0);
      if (std::abs(X - boundary) > 0.012) {
        EXPECT_EQ(result.record.at(column, row).ray_class,
                  X < boundary ? RayClass::kHit : RayClass::kOffscreen)
            << column << " " << row;
      }
    }
    EXPECT_NEAR(boundary, 0.6, 0.02);
  }
}

TEST(OracleClosedForm, OracleGivesTheFormulaOfM3ForEveryThickness) {
  for (const Size size : kSizes) {
    for (const double thickness_m : {kInfinity, 0.5, 1.0, 2.0}) {
      expectOracleAgrees("m3", sceneM3(size), thickness(thickness_m));
    }
    TraceParameters relative = thickness(0.0);
    relative.thickness_rel = 0.25;
    expectOracleAgrees("m3", sceneM3(size), relative);
  }
  EXPECT_EQ(expectOracleAgrees("m3", sceneM3({256, 256}), thickness(1.0)).undecided, 0);
}

TEST(OracleClosedForm, TheFalseHitsOfM3FillTheBandOfTheThickness) {
  // Lower bounds of |Y| by hand: -.1 + 4 / (4 + T); true hits from .9 on.
  const Size size{256, 256};
  const AnalyticScene scene = sceneM3(size);
  const std::vector<std::pair<double, double>> bands = {{0.5, 0.7889}, {1.0, 0.7}, {2.0, 0.5667}};
  for (const auto& [thickness_m, lower_bound] : bands) {
    const OracleResult result = trace(scene, thickness(thickness_m));
    for (int row = 200; row < 256; ++row) {
      const double Y = 2.0 * (row + 0.5) / 256.0 - 1.0;
      const RayHit& hit = result.record.at(128, row);
      const bool hits_lowest_quad_row = hit.ray_class == RayClass::kHit && hit.texel_y == 140;
      // The quad's lowest row of texels ends .8 of a texel above Y = -.1: the band's end moves by as little.
      if (std::abs(Y - lower_bound) > 0.012 && Y < 0.89) {
        EXPECT_EQ(hits_lowest_quad_row, Y > lower_bound) << "T " << thickness_m << " row " << row;
      }
      if (Y > 0.91) {
        EXPECT_EQ(hit.texel_y, static_cast<int>(128.0 * (1.0 - (Y - 1.0)))) << row;
      }
    }
  }
}

TEST(OracleClosedForm, OracleGivesTheFormulaOfM4AtEverySize) {
  for (const Size size : kSizes) {
    for (const double thickness_m : {kInfinity, 1.0}) {
      expectOracleAgrees("m4", sceneM4(size), thickness(thickness_m));
    }
  }
  const Agreement square = expectOracleAgrees("m4", sceneM4({256, 256}));
  // The mirror takes the X from -2/3 to .316 and the height 1 - X / 2 there: 1.07 of 4, or 17500 texels. A
  // fifth of it is left open for the floor, and rays over the wall's upper edge of the image go off the
  // screen.
  EXPECT_GT(square.hits, 9000);
  EXPECT_LT(square.undecided, 4500);
}

TEST(OracleClosedForm, ThePrincipalRayOfM4StaysAtItsDepthAndMeetsTheSideWall) {
  // X' = f x_w / (a D) = .5 for the pixel on the axis; 201 columns put a centre there.
  const OracleResult result = trace(sceneM4({201, 201}));
  const RayHit& hit = result.record.at(100, 100);
  ASSERT_EQ(hit.ray_class, RayClass::kHit);
  EXPECT_NEAR(hit.px_x, 0.5 * 201.0 * 1.5, 0.5 + 1e-3);
  EXPECT_EQ(hit.texel_y, 100);
  // It travels to x_w = 1 at constant depth 4, where a texel is 4 / 201 m wide.
  EXPECT_NEAR(hit.t_m, 1.0, 0.5 * 4.0 / 201.0 + 1e-6);
}

TEST(ClosedForm, ABudgetBelowTheWalkMakesTheFormulaSayBudget) {
  TraceParameters parameters;
  parameters.lookup_budget = 100;
  EXPECT_EQ(expectedAt("m1", {256, 256}, parameters, 0, 209).ray_class, RayClass::kHit);  // 99 cells
  EXPECT_EQ(expectedAt("m1", {256, 256}, parameters, 0, 210).ray_class, RayClass::kBudget);
}

TEST(ClosedForm, WhatTheFormulasLeaveOutIsUndecidedWithAReason) {
  TraceParameters parameters;
  parameters.max_distance_m = 3.0;
  EXPECT_FALSE(expectedAt("m1", {256, 256}, parameters, 0, 210).undecided.empty());
  EXPECT_FALSE(expectedAt("clutter", {256, 256}, {}, 0, 210).undecided.empty());
  EXPECT_EQ(findClosedForm("clutter"), nullptr);
  ASSERT_NE(findClosedForm("m3"), nullptr);
  EXPECT_FALSE(findClosedForm("m3")->formula.empty());
}

}  // namespace ssrkit::testing
