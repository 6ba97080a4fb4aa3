// Surfaces and lights for the tests of the lighting passes, and what they reflect, in double precision and
// written apart from the shaders.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "pass_test.h"

namespace ssrkit {

struct LitSurface {
  glm::dvec3 albedo{0.5};
  double metallic = 0.0;
  double roughness = 0.5;
  glm::dvec3 normal{0.0, 0.0, 1.0};
  double dist_view = 4.0;
  glm::dvec3 emission{0.0};
  double shadow = 1.0;
  double ao = 1.0;
  bool is_traced = true;
};

struct TestLight {
  bool is_directional = false;
  glm::dvec3 place{0.0};  // the way it travels, or where it stands, in view space
  glm::dvec3 strength{1.0};
  double range_m = 0.0;
  glm::dvec3 axis{0.0, 0.0, -1.0};
  double inner = 1.0;
  double outer = -1.0;
};

// The tests' camera: texel (8, 4) of 16 x 8 looks along -z, each texel's ray leans 0.05 further.
inline constexpr Size kLitSize{16, 8};
[[nodiscard]] glm::dvec3 rayOf(int x, int y);  // z is -1
[[nodiscard]] inline std::size_t litIndex(int x, int y) {
  return static_cast<std::size_t>(y) * kLitSize.width + static_cast<std::size_t>(x);
}

// Surfaces of every kind, some of them turned away from the viewer by a hair; the same ones each time.
[[nodiscard]] std::vector<LitSurface> manySurfaces();

// A sun from above, another, two point lights of which one has a range, and a spot light.
[[nodiscard]] std::vector<TestLight> manyLights();

// Irradiance and unit direction from which a light arrives at a point.
struct Arriving {
  glm::dvec3 direction;
  glm::dvec3 irradiance;
};
[[nodiscard]] Arriving arriving(const TestLight& light, glm::dvec3 p_view);

// What light_ggx.frag must add up to: `direct` and `base` (diffuse share of a constant environment) of a
// surface, and its specular albedo for the environment. `split_sum` is the table of environment/split_sum.h.
struct GgxReference {
  glm::dvec3 direct{0.0};
  glm::dvec3 diffuse_albedo{0.0};
  glm::dvec3 specular_albedo{0.0};
};
[[nodiscard]] GgxReference ggxReference(const LitSurface& surface, glm::dvec3 ray,
                                        const std::vector<TestLight>& lights,
                                        const std::vector<float>& split_sum);

// What light.frag must add up to under a sky of this horizon colour.
[[nodiscard]] glm::dvec3 blinnPhongReference(const LitSurface& surface, glm::dvec3 ray,
                                             const std::vector<TestLight>& lights, glm::dvec3 sky_horizon);

// Hands surfaces (a texel each), camera and lights to the pass.
class LitTest : public PassTest {
 protected:
  void giveSurfaces(const std::vector<LitSurface>& surfaces, const std::vector<TestLight>& lights,
                    const glm::dmat4& view_from_world = glm::dmat4(1.0));
};

}  // namespace ssrkit
