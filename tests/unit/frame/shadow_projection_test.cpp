// The fit of the shadow map, in double precision: what it covers, and what stays when the camera moves.
#include "frame/shadow_projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ssrkit {
namespace {

constexpr WorldBounds kRoom{{-14, 0, -6}, {14, 7, 7}};
constexpr WorldBounds kLake{{-3000, -2, -2200}, {3000, 420, 20}};

Camera cameraAt(const glm::dvec3& position, double yaw_rad, double far_m) {
  Camera camera{.size = {1280, 720},
                .clip_from_view = perspective(1.0, 1280.0 / 720.0, 0.1, far_m),
                .view_from_world = glm::dmat4(1.0),
                .near_m = 0.1,
                .far_m = far_m};
  const double c = std::cos(yaw_rad);
  const double s = std::sin(yaw_rad);
  const glm::dmat3 rotation(glm::dvec3(c, 0, -s), glm::dvec3(0, 1, 0), glm::dvec3(s, 0, c));
  camera.view_from_world = glm::dmat4(rotation);
  camera.view_from_world[3] = glm::dvec4(-(rotation * position), 1.0);
  return camera;
}

bool holds(const ShadowCascade& cascade, const glm::dvec2& p_light) {
  const glm::dvec2 px = (p_light - cascade.origin_m) / cascade.texel_m;
  return std::min(px.x, px.y) >= kShadowMarginTexels &&
         std::max(px.x, px.y) <= kShadowSideTexels - kShadowMarginTexels;
}

// Visible points of the scene, drawn at random, are in a cascade with their filter, and before the map's far
// end.
void expectCovered(const WorldBounds& scene, const Camera& camera, const glm::dvec3& way) {
  const ShadowProjection fit = fitShadow(way, scene, camera);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int visible = 0;
  for (int i = 0; i < 200000; ++i) {
    // Half of them near the camera.
    const glm::dvec3 anywhere =
        glm::mix(scene.least, scene.greatest, glm::dvec3(unit(random), unit(random), unit(random)));
    const glm::dvec3 eye(glm::inverse(camera.view_from_world)[3]);
    const glm::dvec3 p_world = glm::mix(eye, anywhere, i % 2 == 0 ? 1.0 : std::pow(unit(random), 4.0));
    const glm::dvec4 p_clip = camera.clip_from_view * camera.view_from_world * glm::dvec4(p_world, 1.0);
    const bool is_visible = std::abs(p_clip.x) <= p_clip.w && std::abs(p_clip.y) <= p_clip.w &&
                            p_clip.z >= 0.0 && p_clip.z <= p_clip.w;
    if (!is_visible || glm::any(glm::lessThan(p_world, scene.least)) ||
        glm::any(glm::greaterThan(p_world, scene.greatest))) {
      continue;
    }
    ++visible;
    const glm::dvec3 p_light(fit.light_from_world * glm::dvec4(p_world, 1.0));
    EXPECT_TRUE(std::ranges::any_of(fit.cascades,
                                    [&](const ShadowCascade& c) { return holds(c, glm::dvec2(p_light)); }))
        << p_world.x << ", " << p_world.y << ", " << p_world.z;
    EXPECT_GT(p_light.z, fit.near_m);
    EXPECT_LT(p_light.z, fit.near_m + fit.range_m);
  }
  EXPECT_GT(visible, 5000);
}

TEST(ShadowProjection, CoversEveryVisiblePointOfTheScene) {
  for (const glm::dvec3& way : {glm::dvec3(0.3, -0.8, -0.5), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1),
                                glm::dvec3(-1, -0.01, 0.02)}) {
    expectCovered(kRoom, cameraAt({0, 2.4, 5.6}, 0.0, 60.0), glm::normalize(way));
    expectCovered(kRoom, cameraAt({30, 3, 40}, -0.6, 200.0), glm::normalize(way));
    expectCovered(kLake, cameraAt({0, 1.1, 0}, 0.1, 5000.0), glm::normalize(way));
  }
}

// The sizes of docs/techniques.md.
TEST(ShadowProjection, ResolvesTheNearPartOfALargeSceneFinely) {
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.3, -0.8, -0.5));
  const ShadowProjection lake = fitShadow(way, kLake, cameraAt({0, 1.1, 0}, 0.0, 5000.0));
  ASSERT_EQ(lake.cascades.size(), 4U);
  EXPECT_LT(lake.cascades[0].texel_m, 0.12);
  EXPECT_LT(lake.cascades[3].texel_m, 8.0);
  const ShadowProjection room = fitShadow(way, kRoom, cameraAt({0, 2.4, 5.6}, 0.0, 60.0));
  EXPECT_LT(room.cascades.back().texel_m, 0.031);  // it has two: the first ends within eight metres
}

TEST(ShadowProjection, KeepsItsTexelsWhereTheyAreWhenTheCameraMoves) {
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.3, -0.8, -0.5));
  for (const WorldBounds& scene : {kRoom, kLake}) {
    const ShadowProjection before = fitShadow(way, scene, cameraAt({0, 1.1, 0}, 0.0, 60.0));
    for (const Camera& moved : {cameraAt({0.37, 1.3, -0.71}, 0.0, 60.0), cameraAt({0, 1.1, 0}, 0.3, 60.0)}) {
      const ShadowProjection after = fitShadow(way, scene, moved);
      EXPECT_EQ(after.near_m, before.near_m);
      for (std::size_t i = 0; i < before.cascades.size(); ++i) {
        ASSERT_EQ(after.cascades[i].texel_m, before.cascades[i].texel_m) << "cascade " << i;
        const glm::dvec2 shift =
            (after.cascades[i].origin_m - before.cascades[i].origin_m) / before.cascades[i].texel_m;
        EXPECT_NEAR(shift.x, std::round(shift.x), 1e-6);
        EXPECT_NEAR(shift.y, std::round(shift.y), 1e-6);
      }
    }
  }
}

TEST(ShadowProjection, OfASceneThatIsAPointIsFinite) {
  const ShadowProjection fit = fitShadow({0, -1, 0}, {{1, 2, 3}, {1, 2, 3}}, cameraAt({0, 0, 0}, 0.0, 60.0));
  EXPECT_GT(fit.range_m, 0.0);
  for (const ShadowCascade& cascade : fit.cascades) {
    EXPECT_GT(cascade.texel_m, 0.0);
    EXPECT_TRUE(std::isfinite(cascade.origin_m.x) && std::isfinite(cascade.origin_m.y));
  }
}

}  // namespace
}  // namespace ssrkit
