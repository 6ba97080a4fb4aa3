// What Oracle B calls the ends of rays: a sphere over a floor, backs, holes, what is behind the camera.
#include <gtest/gtest.h>

#include <cmath>

#include "triangle_world.h"

namespace ssrkit::testing {

TEST(Geometry, OfASphereOverAMirrorFloorIsItsUnderside) {
  const Size size{256, 144};
  const glm::dvec3 centre(0.0, -0.05, -4.5);
  constexpr double kRadius = 0.9;
  constexpr int kRings = 64;
  Scene world = emptyWorld();
  addSphere(world, centre, kRadius, kRings);
  const GeometryResult result = traceWorld(mirrorFloor(size), world);
  std::map<TrueClass, int> counts;
  int different = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const TrueRay& ray = result.at(x, y);
      if (ray.true_class == TrueClass::kNone) {
        continue;
      }
      const glm::dvec3 way = wayOf(size, x, y);
      const glm::dvec3 origin = way / -way.y;
      const glm::dvec3 dir = glm::normalize(glm::dvec3(way.x, -way.y, way.z));
      const double middle = glm::dot(centre - origin, dir);
      const double square = kRadius * kRadius - glm::dot(centre - origin, centre - origin) + middle * middle;
      TrueClass expected = TrueClass::kSky;
      if (square > 0.0 && middle > 0.0) {
        const glm::dvec3 hit = origin + (middle - std::sqrt(square)) * dir;
        // The depth image of this test holds no sphere.
        expected = glm::dot(hit - centre, hit) > 0.0 ? TrueClass::kBackface : TrueClass::kUnsampled;
        // Flat faces instead of the sphere: their sagitta, on the slant.
        if (ray.true_class != TrueClass::kSky && std::sqrt(square) > 0.2) {
          EXPECT_NEAR(ray.t_m, middle - std::sqrt(square), 3e-3) << x << "," << y;
        }
      }
      ++counts[ray.true_class];
      different += ray.true_class == expected ? 0 : 1;
    }
  }
  EXPECT_GT(counts[TrueClass::kBackface], 100);
  EXPECT_GT(counts[TrueClass::kUnsampled], 800);
  // Along the sphere's outline, and where its side turns away from the camera.
  EXPECT_LT(different, 60);
}

TEST(Geometry, BehindTheCameraIsOffscreen) {
  const Size size{96, 54};
  const AnalyticScene gbuffer =
      render(formulaCamera(size), {{.normal_view = {0.0, 0.0, 1.0}, .offset = -4.0, .is_mirror = true}});
  Scene world = emptyWorld();
  // Two metres behind the camera, facing the mirror.
  addQuad(world, {2, -1, 2}, {-2, -1, 2}, {-2, 1, 2}, {2, 1, 2});
  const GeometryResult result = traceWorld(gbuffer, world);
  int hits = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const glm::dvec3 at_quad = 10.0 * wayOf(size, x, y);
      const bool meets = std::abs(at_quad.x) < 2.0 && std::abs(at_quad.y) < 1.0;
      const TrueRay& ray = result.at(x, y);
      EXPECT_EQ(ray.true_class, meets ? TrueClass::kOffscreen : TrueClass::kSky) << x << "," << y;
      hits += meets ? 1 : 0;
      if (meets) {
        EXPECT_NEAR(ray.dist_view, -2.0, 1e-6);
      }
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(Geometry, ASheetOverTheFloorIsABackfaceUnlessItsUndersideIsNotDrawn) {
  const Size size{96, 54};
  const auto classesUnder = [&](bool double_sided, bool faces_up) {
    Scene world = emptyWorld();
    Material material;
    material.double_sided = double_sided;
    const int sheet = addMaterial(world, material);
    if (faces_up) {
      addQuad(world, {-1, -0.5F, -2}, {1, -0.5F, -2}, {1, -0.5F, -6}, {-1, -0.5F, -6}, sheet);
    } else {
      addQuad(world, {-1, -0.5F, -6}, {1, -0.5F, -6}, {1, -0.5F, -2}, {-1, -0.5F, -2}, sheet);
    }
    return countClasses(traceWorld(mirrorFloor(size), world));
  };
  const auto drawn = classesUnder(true, true);
  const int backfaces = drawn.at(TrueClass::kBackface);
  EXPECT_GT(backfaces, 100);
  EXPECT_EQ(drawn.size(), 3U);  // and the sky, and the upper half without rays
  EXPECT_EQ(classesUnder(true, false).at(TrueClass::kBackface), backfaces);
  EXPECT_EQ(classesUnder(false, false).at(TrueClass::kBackface), backfaces);
  EXPECT_EQ(classesUnder(false, true).count(TrueClass::kBackface), 0U);
  EXPECT_EQ(classesUnder(false, true).at(TrueClass::kSky), drawn.at(TrueClass::kSky) + backfaces);
}

TEST(Geometry, ALeafsHolesLetRaysThrough) {
  const Size size{96, 54};
  Scene world = emptyWorld();
  Texture texture;
  texture.size = {2, 1};
  texture.wrap_u = Wrap::kClamp;
  texture.rgba = {255, 255, 255, 255, 255, 255, 255, 0};
  world.textures.push_back(texture);
  Material leaf;
  leaf.double_sided = true;
  leaf.alpha_mode = AlphaMode::kMask;
  leaf.base_colour_texture = 0;
  addQuad(world, {-1, -0.5F, -2}, {1, -0.5F, -2}, {1, -0.5F, -6}, {-1, -0.5F, -6}, addMaterial(world, leaf));
  const GeometryResult result = traceWorld(mirrorFloor(size), world);
  int drawn = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (result.at(x, y).true_class == TrueClass::kBackface) {
        ++drawn;
        EXPECT_LT(x + 0.5, 0.5 * size.width) << y;  // the left half, where the texture's alpha is over a half
      }
    }
  }
  EXPECT_GT(drawn, 50);
}

TEST(Geometry, EndsWhereTheRayIsLongEnough) {
  const Size size{64, 36};
  TraceParameters parameters;
  parameters.max_distance_m = 5.0;
  const GeometryResult result = traceWorld(sceneM1(size), worldM1(), parameters);
  int near = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const TrueRay& ray = result.at(x, y);
      if (ray.true_class == TrueClass::kNone) {
        continue;
      }
      const glm::dvec3 way = wayOf(size, x, y);
      const double t_m = (8.0 + 1.0 / way.y) * glm::length(way);
      EXPECT_EQ(ray.true_class, t_m < 5.0 ? TrueClass::kVisible : TrueClass::kSky) << x << "," << y;
      near += t_m < 5.0 ? 1 : 0;
    }
  }
  EXPECT_GT(near, 100);
}

TEST(Geometry, TwoThreadsSayWhatOneSays) {
  const AnalyticScene gbuffer = sceneM4({97, 61});
  const GeometryResult one = traceWorld(gbuffer, worldM4(), {}, 1);
  const GeometryResult two = traceWorld(gbuffer, worldM4(), {}, 2);
  ASSERT_EQ(one.pixelCount(), two.pixelCount());
  for (std::size_t i = 0; i < one.pixelCount(); ++i) {
    EXPECT_EQ(one.at(i).true_class, two.at(i).true_class);
    EXPECT_EQ(one.at(i).t_m, two.at(i).t_m);
    EXPECT_EQ(one.at(i).plane.px, two.at(i).plane.px);
  }
}

TEST(Geometry, RefusesImagesOfOtherSizes) {
  AnalyticScene gbuffer = sceneM1({32, 32});
  gbuffer.normal_view = Image({16, 16}, {"X", "Y", "Z"});
  EXPECT_FALSE(traceGeometry(gbuffer.input(), surfacesOf(worldM1())));
}

}  // namespace ssrkit::testing
