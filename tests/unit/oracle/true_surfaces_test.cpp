// Rays among triangles, against a loop over all of them.
#include "oracle/true_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "triangle_world.h"

namespace ssrkit::testing {

namespace {

glm::dvec3 randomPoint(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return {x, y, coordinate(random)};
}

// A few hundred triangles of all sizes, in two materials.
Scene triangleSoup(std::mt19937& random) {
  Scene scene = emptyWorld();
  Material both_sides;
  both_sides.double_sided = true;
  addMaterial(scene, both_sides);
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 centre(randomPoint(random, 10.0));
    const double size = std::pow(10.0, -1.0 + 0.005 * i);
    addTriangle(scene, centre + glm::vec3(randomPoint(random, size)),
                centre + glm::vec3(randomPoint(random, size)), centre + glm::vec3(randomPoint(random, size)),
                i % 2);
  }
  return scene;
}

SurfaceRay rayFrom(glm::dvec3 origin, glm::dvec3 dir) {
  return {.origin_view = origin, .dir_view = glm::normalize(dir)};
}

}  // namespace

TEST(TrueSurfaces, FindWhatALoopOverAllTrianglesFinds) {
  std::mt19937 random(7);
  const Scene scene = triangleSoup(random);
  const TrueSurfaces surfaces = surfacesOf(scene);
  int hits = 0;
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const SurfaceRay ray = rayFrom(randomPoint(random, 12.0), randomPoint(random, 1.0));
    const auto expected = loopOverTriangles(scene, ray.origin_view, ray.dir_view);
    // Single precision cannot tell which side of an edge a ray passes within rounding of it.
    if (expected && expected->edge_distance < 1e-4) {
      continue;
    }
    const auto actual = surfaces.firstHit(ray);
    ++compared;
    if (expected.has_value() != actual.has_value() || (expected && expected->triangle != actual->triangle)) {
      ADD_FAILURE() << "ray " << i << ": triangle " << (expected ? int(expected->triangle) : -1)
                    << " against " << (actual ? int(actual->triangle) : -1);
      continue;
    }
    if (expected) {
      ++hits;
      // Both in double precision: the distance is not Embree's.
      EXPECT_NEAR(actual->t_m, expected->t_m, 1e-9 * std::max(1.0, expected->t_m));
      EXPECT_NEAR(glm::length(actual->normal_view), 1.0, 1e-12);
      EXPECT_LT(glm::dot(actual->normal_view, ray.dir_view), 0.0);
    }
  }
  EXPECT_GT(compared, 19500);
  EXPECT_GT(hits, 5000);
}

TEST(TrueSurfaces, TheBackOfASingleSidedTriangleIsNotThere) {
  Scene scene = emptyWorld();
  addQuad(scene, {-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2});
  Material both_sides;
  both_sides.double_sided = true;
  const int material = addMaterial(scene, both_sides);
  addQuad(scene, {-1, -1, -3}, {1, -1, -3}, {1, 1, -3}, {-1, 1, -3}, material);
  const TrueSurfaces surfaces = surfacesOf(scene);
  const auto from_front = surfaces.firstHit(rayFrom({0.3, 0.2, 0.0}, {0.0, 0.0, -1.0}));
  const auto from_back = surfaces.firstHit(rayFrom({0.3, 0.2, -10.0}, {0.0, 0.0, 1.0}));
  const auto between = surfaces.firstHit(rayFrom({0.3, 0.2, -2.5}, {0.0, 0.0, 1.0}));
  ASSERT_TRUE(from_front && from_back);
  EXPECT_DOUBLE_EQ(from_front->t_m, 2.0);
  EXPECT_DOUBLE_EQ(from_back->t_m, 7.0);
  EXPECT_EQ(from_back->normal_view, glm::dvec3(0.0, 0.0, -1.0));
  EXPECT_FALSE(between);
}

TEST(TrueSurfaces, WhatItsMaterialCutsOutIsNotThere) {
  Scene scene = emptyWorld();
  // 4 x 1 texels: drawn where the alpha is over a half, the left half of the quad.
  Texture texture;
  texture.size = {4, 1};
  texture.wrap_u = Wrap::kClamp;
  texture.rgba = {9, 9, 9, 255, 9, 9, 9, 255, 9, 9, 9, 0, 9, 9, 9, 0};
  scene.textures.push_back(texture);
  Material leaf;
  leaf.alpha_mode = AlphaMode::kMask;
  leaf.base_colour_texture = 0;
  const int material = addMaterial(scene, leaf);
  addQuad(scene, {-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2}, material);
  addQuad(scene, {-2, -2, -5}, {2, -2, -5}, {2, 2, -5}, {-2, 2, -5});
  const TrueSurfaces surfaces = surfacesOf(scene);
  for (int i = 0; i < 100; ++i) {
    const double x = -0.99 + 0.02 * i;
    const auto hit = surfaces.firstHit(rayFrom({x, 0.3, 0.0}, {0.0, 0.0, -1.0}));
    ASSERT_TRUE(hit) << x;
    EXPECT_DOUBLE_EQ(hit->t_m, x < 0.0 ? 2.0 : 5.0) << x;
  }
}

TEST(TrueSurfaces, HoldNothingWithoutTriangles) {
  EXPECT_FALSE(surfacesOf(emptyWorld()).firstHit(rayFrom({0, 0, 0}, {0, 0, -1})));
}

TEST(TrueSurfaces, ATriangleOfNoAreaIsNeverMet) {
  Scene scene = emptyWorld();
  Material both_sides;
  both_sides.double_sided = true;
  const int material = addMaterial(scene, both_sides);
  addTriangle(scene, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}, material);   // a point on the ray
  addTriangle(scene, {-1, 0, -2}, {0, 0, -2}, {1, 0, -2}, material);  // a line across it
  addTriangle(scene, {0, 0, 0}, {0, 0, -3}, {0, 0, -9}, material);    // a line along it
  addTriangle(scene, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, material);      // a point at its origin
  const float far = std::numeric_limits<float>::max();
  addTriangle(scene, {far, far, -far}, {-far, far, far}, {far, -far, far}, material);  // beyond all bounds
  const TrueSurfaces surfaces = surfacesOf(scene);
  EXPECT_FALSE(surfaces.firstHit(rayFrom({0, 0, 0}, {0, 0, -1})));
  addQuad(scene, {-1, -1, -4}, {1, -1, -4}, {1, 1, -4}, {-1, 1, -4});
  const auto hit = surfacesOf(scene).firstHit(rayFrom({0, 0, 0}, {0, 0, -1}));
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->t_m, 4.0);
}

TEST(TrueSurfaces, EndARayAtItsLength) {
  Scene scene = emptyWorld();
  addQuad(scene, {-1, -1, -4}, {1, -1, -4}, {1, 1, -4}, {-1, 1, -4});
  const TrueSurfaces surfaces = surfacesOf(scene);
  SurfaceRay ray = rayFrom({0.1, 0.2, 0}, {0, 0, -1});
  ray.max_t_m = 3.99;
  EXPECT_FALSE(surfaces.firstHit(ray));
  ray.max_t_m = 4.01;
  EXPECT_TRUE(surfaces.firstHit(ray));
  ray.min_t_m = 4.001;
  EXPECT_FALSE(surfaces.firstHit(ray));
}

TEST(TrueSurfaces, OnlyTheSurfaceThatTheRayLeavesIsPassedOver) {
  Scene scene = emptyWorld();
  addQuad(scene, {-5, -1, 0}, {5, -1, 0}, {5, -1, -10}, {-5, -1, -10});  // a floor below the camera
  addQuad(scene, {-5, -1, -6}, {5, -1, -6}, {5, 3, -6}, {-5, 3, -6});    // and a wall on it
  const TrueSurfaces surfaces = surfacesOf(scene);
  SurfaceRay ray = rayFrom({0.5, -1.0 - 1e-6, -4.0}, {0.0, 1.0, -4.0});
  const auto wall = surfaces.firstHit(ray);
  // The floor's back is not there, so a ray from below it is free even without a word on its origin.
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->t_m, 0.5 * std::sqrt(17.0), 1e-12);

  Scene sheet = emptyWorld();
  Material both_sides;
  both_sides.double_sided = true;
  addQuad(sheet, {-5, -1, 0}, {5, -1, 0}, {5, -1, -10}, {-5, -1, -10}, addMaterial(sheet, both_sides));
  const TrueSurfaces sheets = surfacesOf(sheet);
  EXPECT_TRUE(sheets.firstHit(ray));
  ray.origin_error[1] = {0.0, 2e-6, 0.0};
  EXPECT_FALSE(sheets.firstHit(ray));
  ray.origin_view.y = -1.0 - 2e-5;  // farther behind than the origin may be: another surface
  EXPECT_TRUE(sheets.firstHit(ray));
  ray.origin_view.y = -1.0 + 1e-7;  // into the surface: never passed over
  ray.dir_view = glm::normalize(glm::dvec3(0.0, -1.0, -4.0));
  EXPECT_TRUE(sheets.firstHit(ray));
}

}  // namespace ssrkit::testing
