// G-buffers made by formula, a texel at a time, for testing the oracle: no rasteriser, no file.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "image/image.h"
#include "oracle/oracle.h"
#include "spaces/camera.h"

namespace ssrkit::testing {

// A plane in view space, n . p = offset, bounded by `contains` (view position).
struct Surface {
  glm::dvec3 normal_view{0.0, 0.0, 1.0};
  double offset = 0.0;
  bool is_mirror = false;
  std::function<bool(glm::dvec3)> contains = [](glm::dvec3) { return true; };
};

// Owns what an OracleInput points at.
struct AnalyticScene {
  Camera camera;
  Image dist_view;
  Image normal_view;
  Image mask;

  [[nodiscard]] OracleInput input(const TraceParameters& parameters = {}) const {
    return {.camera = &camera,
            .dist_view = &dist_view,
            .normal_view = &normal_view,
            .mask = &mask,
            .parameters = parameters};
  }
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The camera of the closed forms: f = 2 (fov_y = 2 atan 1/2), near 0.1 m.
[[nodiscard]] Camera formulaCamera(Size size);

// Every texel takes the nearest surface at its centre, rounded to float; none: background. Normals face the
// camera.
[[nodiscard]] AnalyticScene render(const Camera& camera, const std::vector<Surface>& surfaces);

// A frontal surface at dist_view 5 everywhere, for tests that set single texels by hand.
[[nodiscard]] AnalyticScene flatScene(Size size);

// The scenes of the closed forms.
[[nodiscard]] AnalyticScene sceneM1(Size size);
[[nodiscard]] AnalyticScene sceneM2(Size size);
[[nodiscard]] AnalyticScene sceneM3(Size size);
[[nodiscard]] AnalyticScene sceneM4(Size size);

// Traces and stops the test when the oracle refuses.
[[nodiscard]] OracleResult trace(const AnalyticScene& scene, const TraceParameters& parameters = {},
                                 int thread_count = 2);

}  // namespace ssrkit::testing
