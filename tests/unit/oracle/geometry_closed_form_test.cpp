// Oracle B against closed forms: where the rays of planar mirrors truly end.
#include "oracle/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "triangle_world.h"

namespace ssrkit::testing {

namespace {

// Relative to the hit's distance from the camera: dist_view is rounded to single precision.
constexpr double kSingle = 4e-7;

}  // namespace

TEST(Geometry, OfM1IsTheWallTurnedUpsideDownAndAllOfItIsVisible) {
  for (const Size size : kWorldSizes) {
    const GeometryResult result = traceWorld(sceneM1(size), worldM1());
    int rays = 0;
    for (int y = 0; y < size.height; ++y) {
      const double mirrored_row = 1.25 * size.height - (y + 0.5);
      for (int x = 0; x < size.width; ++x) {
        const TrueRay& ray = result.at(x, y);
        if (ray.true_class == TrueClass::kNone) {
          EXPECT_LT(y + 0.5, 0.625 * size.height);
          continue;
        }
        ++rays;
        const glm::dvec3 way = wayOf(size, x, y);
        const double floor_dist = -1.0 / way.y;
        // Met in the row where the wall stands on the floor, whose centres may show the floor.
        const bool is_contact = mirrored_row + 1.0 > 0.625 * size.height;
        if (!is_contact) {
          EXPECT_EQ(ray.true_class, TrueClass::kVisible) << x << "," << y;
        }
        EXPECT_NEAR(ray.plane.px.x, x + 0.5, 1e-4);
        EXPECT_NEAR(ray.plane.px.y, mirrored_row, 1e-4);
        EXPECT_NEAR(ray.dist_view, 8.0, 8.0 * kSingle);
        EXPECT_NEAR(ray.t_m, (8.0 - floor_dist) * glm::length(way), 8.0 * kSingle);
        EXPECT_NEAR(glm::length(ray.plane.inv_dist_per_px), 0.0, 1e-12);
      }
    }
    EXPECT_GT(rays, size.width * (size.height / 3));
  }
}

TEST(Geometry, OfM2IsTheFloorUpToBehindTheCamera) {
  for (const Size size : kWorldSizes) {
    const GeometryResult result = traceWorld(sceneM2(size), worldM2());
    std::map<TrueClass, int> counts;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const glm::dvec2 ndc = ndcOf(size, x, y);
        const TrueRay& ray = result.at(x, y);
        if (ray.true_class == TrueClass::kNone) {
          continue;
        }
        ++counts[ray.true_class];
        const double dist = ndc.y < 0.0 ? 8.0 + 2.0 / ndc.y : -std::numeric_limits<double>::infinity();
        const double p_x = 0.5 * ndc.x * size.width / size.height * (8.0 - dist);
        if (std::abs(dist + 12.0) < 1e-6) {
          continue;  // the floor's very edge
        }
        if (dist < -12.0 || std::abs(p_x) > 12.0) {
          EXPECT_EQ(ray.true_class, TrueClass::kSky) << x << "," << y;
          continue;
        }
        EXPECT_NEAR(ray.dist_view, dist, 40.0 * kSingle);
        const glm::dvec2 px = pxOf(size, {p_x, -1.0, -dist});
        const bool is_inside = dist > 0.1 && px.x >= 0.0 && px.x < size.width && px.y < size.height;
        // Where floor and mirror meet, the texel's centre may show the mirror.
        if (is_inside && px.y < 0.75 * size.height + 1.0) {
          continue;
        }
        EXPECT_EQ(ray.true_class, is_inside ? TrueClass::kVisible : TrueClass::kOffscreen) << x << "," << y;
        if (is_inside) {
          EXPECT_NEAR(ray.plane.px.x, px.x, 1e-3);
          EXPECT_NEAR(ray.plane.px.y, px.y, 1e-3);
        }
      }
    }
    EXPECT_GT(counts[TrueClass::kSky], 0);
    if (size.height > 50) {
      EXPECT_GT(counts[TrueClass::kVisible], 0);
      EXPECT_GT(counts[TrueClass::kOffscreen], 0);
    }
  }
}

TEST(Geometry, OfM3IsOccludedExactlyWhereTheQuadStandsBeforeTheWall) {
  for (const Size size : kWorldSizes) {
    const GeometryResult result = traceWorld(sceneM3(size), worldM3());
    std::map<TrueClass, int> counts;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const TrueRay& ray = result.at(x, y);
        const glm::dvec3 way = wayOf(size, x, y);
        const double depth = -ndcOf(size, x, y).y;
        const double at_quad = depth - 1.0;  // NDC Y of the ray at dist_view 4 and 8: |Y| - 2hf / dist
        const double at_wall = depth - 0.5;
        const double edge = 2.0 / size.height;  // a texel
        const bool is_near_edge = std::abs(std::abs(4.0 * way.x) - 1.0) < 4.0 * edge ||
                                  std::abs(at_quad + 0.1) < edge || std::abs(at_quad - 0.3) < edge ||
                                  std::abs(at_wall + 0.1) < edge || std::abs(at_wall - 0.3) < edge;
        const bool is_contact = std::abs(at_wall + 0.25) < edge;  // where the wall stands on the floor
        if (ray.true_class == TrueClass::kNone || is_near_edge || is_contact) {
          continue;
        }
        ++counts[ray.true_class];
        const bool in_column = std::abs(4.0 * way.x) < 1.0;
        // The floor nearer than the quad: its ray passes the quad's plane.
        const bool meets_quad = in_column && depth > 0.5 && at_quad > -0.1 && at_quad < 0.3;
        const bool is_hidden = in_column && !meets_quad && at_wall > -0.1 && at_wall < 0.3;
        EXPECT_NEAR(ray.dist_view, meets_quad ? 4.0 : 8.0, 8.0 * kSingle) << x << "," << y;
        EXPECT_EQ(ray.true_class, is_hidden ? TrueClass::kOccluded : TrueClass::kVisible) << x << "," << y;
      }
    }
    if (size.width > 50) {
      EXPECT_GT(counts[TrueClass::kOccluded], 0) << size.width;
    }
  }
}

TEST(Geometry, OfM4IsWhatALoopOverAllTrianglesFinds) {
  const Size size{160, 90};
  const AnalyticScene gbuffer = sceneM4(size);
  const Scene world = worldM4();
  const GeometryResult result = traceWorld(gbuffer, world);
  int compared = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const TrueRay& ray = result.at(x, y);
      if (ray.true_class == TrueClass::kNone) {
        continue;
      }
      // The mirror x + z = -4 swaps the direction's x and -z.
      const glm::dvec3 way = wayOf(size, x, y);
      const glm::dvec3 origin = 4.0 / (1.0 - way.x) * way;
      const glm::dvec3 dir = glm::normalize(glm::dvec3(-way.z, way.y, -way.x));
      const auto expected = loopOverTriangles(world, origin, dir, 1e-5);
      ASSERT_EQ(expected.has_value(), ray.true_class != TrueClass::kSky) << x << "," << y;
      if (expected && expected->edge_distance > 1e-3) {
        ++compared;
        EXPECT_NEAR(ray.t_m, expected->t_m, 1e-5) << x << "," << y;
        const glm::dvec2 px = pxOf(size, origin + expected->t_m * dir);
        const bool is_inside = px.x >= 0.0 && px.x < size.width && px.y >= 0.0 && px.y < size.height;
        EXPECT_EQ(ray.true_class, is_inside ? TrueClass::kVisible : TrueClass::kOffscreen) << x << "," << y;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(TrueDistView, IsTheDepthImageOfTheSamePlanes) {
  // Sizes at which no edge of the quad runs through a row or column of centres.
  for (const Size size : {Size{256, 256}, Size{160, 88}, Size{127, 63}, Size{33, 97}, Size{5, 7}}) {
    const AnalyticScene gbuffer = sceneM3(size);
    const Image seen = trueDistView(gbuffer.camera, surfacesOf(worldM3()));
    int different = 0;
    for (std::size_t i = 0; i < seen.texelCount(); ++i) {
      const float expected = gbuffer.dist_view.data[i];
      // The planes of the G-buffer are endless, the world's are not: its sky is left out.
      different += std::isinf(seen.data[i]) || std::abs(seen.data[i] - expected) < 1e-6F * expected ? 0 : 1;
    }
    EXPECT_EQ(different, 0) << size.width << "x" << size.height;
  }
}

}  // namespace ssrkit::testing
