// The tracing contract, a sentence at a time, on G-buffers made by hand: what is a hit.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analytic_scene.h"
#include "contract_rays.h"

namespace ssrkit::testing {

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

}  // namespace ssrkit::testing
