// When a texel holds a surface.
#include <gtest/gtest.h>

#include <cmath>

#include "triangle_world.h"

namespace ssrkit::testing {

namespace {

// A texel of 100 px per unit: half a texel is 5 mm wide at a distance of 1 m.
const PixelProjection kProjection{.px_scale = {100.0, -100.0}, .px_offset = {8.0, 8.0}};

Image depthOf(double dist) {
  Image image({16, 16}, {"Z"});
  std::ranges::fill(image.data, static_cast<float>(dist));
  return image;
}

bool match(const PlaneInImage& plane, double dist) {
  return holdsSurface(plane, kProjection, depthOf(dist), 5, 6);
}

// Met in the texel's centre.
PlaneInImage planeAt(double dist, glm::dvec2 inv_dist_per_px = glm::dvec2(0.0)) {
  return {.px = {5.5, 6.5}, .inv_dist = 1.0 / dist, .inv_dist_per_px = inv_dist_per_px};
}

}  // namespace

TEST(HoldsSurface, AFrontalSurfaceIsKnownToHalfATexelsWidth) {
  EXPECT_TRUE(match(planeAt(2.0), 2.0));
  EXPECT_TRUE(match(planeAt(2.0), 2.0 - 0.0099));
  EXPECT_TRUE(match(planeAt(2.0), 2.0 + 0.0099));
  EXPECT_FALSE(match(planeAt(2.0), 2.0 - 0.0101));
  EXPECT_FALSE(match(planeAt(2.0), 2.0 + 0.0102));
}

TEST(HoldsSurface, ASlantedOneToHalfATexelsSlope) {
  const PlaneInImage plane = planeAt(2.0, {0.02, -0.03});
  const double tolerance = 0.5 * 0.05 + 0.005 * 0.5;
  EXPECT_TRUE(match(plane, 1.0 / (0.5 + 0.99 * tolerance)));
  EXPECT_FALSE(match(plane, 1.0 / (0.5 + 1.01 * tolerance)));
  EXPECT_TRUE(match(plane, 1.0 / (0.5 - 0.99 * tolerance)));
  EXPECT_FALSE(match(plane, 1.0 / (0.5 - 1.01 * tolerance)));
}

TEST(HoldsSurface, IsAskedAtTheTexelsCentre) {
  PlaneInImage plane = planeAt(2.0, {0.1, 0.0});
  plane.px = {5.1, 6.5};  // 0.4 px to the left of the centre: 1/dist is 0.54 there
  EXPECT_TRUE(match(plane, 1.0 / 0.54));
  EXPECT_TRUE(match(plane, 1.0 / (0.54 + 0.051)));
  EXPECT_FALSE(match(plane, 1.0 / (0.54 + 0.054)));
  EXPECT_FALSE(match(plane, 1.0 / (0.54 - 0.054)));
}

TEST(HoldsSurface, BackgroundIsNoSurface) {
  EXPECT_FALSE(match(planeAt(2.0), kInfinity));
}

TEST(Geometry, ABarBetweenTheTexelsCentresIsUnsampled) {
  const Size size{64, 64};
  Scene world = worldM1();
  // A third of a texel wide, 4 m ahead: no texel's centre sees it.
  const float width = 4.0F / 64.0F / 3.0F;
  addQuad(world, {0.01F, -1, -4}, {0.01F + width, -1, -4}, {0.01F + width, 1, -4}, {0.01F, 1, -4});
  AnalyticScene gbuffer = sceneM1(size);
  gbuffer.dist_view = trueDistView(gbuffer.camera, surfacesOf(world));
  for (std::size_t i = 0; i < gbuffer.dist_view.texelCount(); ++i) {
    ASSERT_FLOAT_EQ(gbuffer.dist_view.data[i], sceneM1(size).dist_view.data[i]);
  }
  // A ray of the mirror's own column would have to start in the bar's texel: the mirror is turned.
  const double turn = 0.1;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (gbuffer.mask.at(x, y) > 0.0F) {
        gbuffer.normal_view.at(x, y, 0) = static_cast<float>(turn);
        gbuffer.normal_view.at(x, y, 1) = static_cast<float>(std::sqrt(1.0 - turn * turn));
      }
    }
  }
  const GeometryResult result = traceWorld(gbuffer, world);
  int unsampled = 0;
  for (const TrueRay& ray : raysOf(result)) {
    if (ray.true_class == TrueClass::kUnsampled) {
      ++unsampled;
      EXPECT_NEAR(ray.dist_view, 4.0, 1e-5);
    }
  }
  EXPECT_GT(unsampled, 5);
}

}  // namespace ssrkit::testing
