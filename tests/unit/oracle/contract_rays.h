// What the tests of the tracing contract share: a mirror across the view, a normal set by hand, and two rays
// held equal.
#pragma once

#include <gtest/gtest.h>

#include "analytic_scene.h"

namespace ssrkit::testing {

// A frontal mirror at dist_view 10: the ray of a pixel d texels right of the centre is seen at d (20 - dist)
// / dist.
inline AnalyticScene frontalMirrorAt10(Size size) {
  return render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
}

inline void setNormal(AnalyticScene& scene, int x, int y, glm::dvec3 normal, float cosine = 1.0F) {
  for (int axis = 0; axis < 3; ++axis) {
    scene.normal_view.at(x, y, static_cast<std::size_t>(axis)) = static_cast<float>(normal[axis]);
  }
  scene.normal_view.at(x, y, 3) = cosine;
}

inline void expectSameRay(const RayHit& a, const RayHit& b) {
  EXPECT_EQ(a.ray_class, b.ray_class);
  EXPECT_EQ(a.texel_x, b.texel_x);
  EXPECT_EQ(a.texel_y, b.texel_y);
  EXPECT_EQ(a.px_x, b.px_x);
  EXPECT_EQ(a.px_y, b.px_y);
  EXPECT_EQ(a.t_m, b.t_m);
  EXPECT_EQ(a.lookups, b.lookups);
  EXPECT_EQ(a.steps, b.steps);
}

}  // namespace ssrkit::testing
