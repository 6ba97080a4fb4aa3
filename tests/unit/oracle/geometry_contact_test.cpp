// Where a ray starts: no surface is met by the rays that leave it, and nothing near it is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "triangle_world.h"

namespace ssrkit::testing {

namespace {

// A square of the plane z = -dist + slope_x x + slope_y y, in `cells` x `cells` pairs of triangles, both
// sides of which are drawn: a ray that starts behind it would meet it.
Scene tiledPlane(double dist, double slope_x, double slope_y, int cells) {
  Scene scene = emptyWorld();
  Material both_sides;
  both_sides.double_sided = true;
  const int material = addMaterial(scene, both_sides);
  const auto at = [&](int i, int j) {
    const double x = -8.0 + 16.0 * i / cells;
    const double y = -8.0 + 16.0 * j / cells;
    return glm::vec3(glm::dvec3(x, y, -dist + slope_x * x + slope_y * y));
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      addQuad(scene, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), material);
    }
  }
  return scene;
}

AnalyticScene mirrorPlane(Size size, double dist, double slope_x, double slope_y) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope_x, -slope_y, 1.0));
  const auto is_near = [](glm::dvec3 p) { return std::abs(p.x) < 8.0 && std::abs(p.y) < 8.0; };
  return render(
      formulaCamera(size),
      {{.normal_view = normal, .offset = -dist * normal.z, .is_mirror = true, .contains = is_near}});
}

int countRaysThatMeetSomething(const GeometryResult& result) {
  int count = 0;
  for (const TrueRay& ray : raysOf(result)) {
    count += ray.t_m >= 0.0 ? 1 : 0;
  }
  return count;
}

int countRays(const GeometryResult& result) {
  int count = 0;
  for (const TrueRay& ray : raysOf(result)) {
    count += ray.true_class != TrueClass::kNone ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST(GeometryContact, APlanarMirrorNeverMeetsItselfHoweverItIsTiled) {
  for (const auto& [slope_x, slope_y] :
       {std::pair(0.0, 0.0), std::pair(0.3, -0.2), std::pair(-2.0, 0.7), std::pair(0.1, 20.0)}) {
    for (const int cells : {1, 7}) {
      for (const double dist : {0.5, 6.0}) {
        const GeometryResult result = traceWorld(mirrorPlane({160, 90}, dist, slope_x, slope_y),
                                                 tiledPlane(dist, slope_x, slope_y, cells));
        EXPECT_EQ(countRaysThatMeetSomething(result), 0) << slope_x << " " << slope_y << " " << cells;
        EXPECT_GT(countRays(result), 1000);
      }
    }
  }
}

TEST(GeometryContact, NorDoesItWhenItsDepthsAreOffByAsMuchAsARasterisersAre) {
  AnalyticScene gbuffer = mirrorPlane({160, 90}, 6.0, 0.3, -0.2);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> error(-3.5e-6F, 3.5e-6F);
  for (float& dist : gbuffer.dist_view.data) {
    dist *= 1.0F + error(random);
  }
  const GeometryResult result = traceWorld(gbuffer, tiledPlane(6.0, 0.3, -0.2, 7));
  EXPECT_EQ(countRaysThatMeetSomething(result), 0);
}

TEST(GeometryContact, ThinGapIsNotLost) {
  const Size size{160, 90};
  const AnalyticScene gbuffer =
      render(formulaCamera(size), {{.normal_view = {0.0, 1.0, 0.0}, .offset = -1.0, .is_mirror = true}});
  for (const float gap_m : {1e-1F, 1e-2F, 1e-3F, 3e-4F}) {
    Scene world = emptyWorld();
    Material both_sides;
    both_sides.double_sided = true;
    const int material = addMaterial(world, both_sides);
    addQuad(world, {-9, -1, 0}, {9, -1, 0}, {9, -1, -9}, {-9, -1, -9}, material);
    const float y = -1.0F + gap_m;
    addQuad(world, {-9, y, 0}, {9, y, 0}, {9, y, -9}, {-9, y, -9}, material);
    const GeometryResult result = traceWorld(gbuffer, world);
    int under = 0;
    for (int row = size.height / 2; row < size.height; ++row) {
      const double floor_dist = size.height / (row + 0.5 - 0.5 * size.height);
      if (floor_dist > 7.0) {
        continue;
      }
      const TrueRay& ray = result.at(size.width / 2, row);
      ++under;
      EXPECT_EQ(ray.true_class, TrueClass::kBackface) << gap_m << " row " << row;
      // As far as along the viewing ray from the sheet's plane to the floor's.
      const double length = std::hypot(1.0, 1.0 / floor_dist) * floor_dist;
      EXPECT_NEAR(ray.t_m, gap_m * length, 0.05 * gap_m * length) << gap_m << " row " << row;
    }
    EXPECT_GT(under, 20);
  }
}

TEST(GeometryContact, AWallAtTheFloorsEdgeIsMetFromTheLastMicrometre) {
  const Size size{64, 64};
  Scene world = worldM1();
  AnalyticScene gbuffer = sceneM1(size);
  // The pixel's point moved along its viewing ray to just before the wall; the floor is where the point is.
  const int x = 32;
  const int y = 48;
  for (const double before_m : {1e-2, 1e-4, 1e-6}) {
    const double dist = 8.0 - before_m;
    const double way_y = 0.5 - (y + 0.5) / size.height;
    const auto height = static_cast<float>(dist * way_y);
    Scene moved = emptyWorld();
    addQuad(moved, {-12, height, 2}, {12, height, 2}, {12, height, -8}, {-12, height, -8});
    addQuad(moved, {-12, -5, -8}, {12, -5, -8}, {12, 5, -8}, {-12, 5, -8});
    gbuffer.dist_view.at(x, y) = static_cast<float>(dist);
    const GeometryResult result = traceWorld(gbuffer, moved);
    EXPECT_EQ(result.at(x, y).true_class == TrueClass::kSky, false) << before_m;
    EXPECT_NEAR(result.at(x, y).t_m, before_m, 0.1 * before_m + 1e-6) << before_m;
  }
}

TEST(GeometryContact, TheBiasMovesTheOriginAsItDoesForOracleA) {
  const Size size{64, 64};
  TraceParameters parameters;
  parameters.origin_bias = 0.01;
  const GeometryResult result = traceWorld(sceneM1(size), worldM1(), parameters);
  // From h = 1 - bias * dist below the camera the wall is met as if the floor lay higher.
  for (int y = 44; y < 64; ++y) {
    const double way_y = 0.5 - (y + 0.5) / size.height;
    const double dist = -1.0 / way_y;
    const double hit_y = -1.0 + 0.01 * dist + (8.0 - dist) * -way_y;
    EXPECT_NEAR(result.at(20, y).plane.px.y, size.height * (0.5 - hit_y / 8.0), 1e-4) << y;
  }
}

}  // namespace ssrkit::testing
