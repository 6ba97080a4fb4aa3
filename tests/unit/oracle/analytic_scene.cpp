#include "analytic_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace ssrkit::testing {

namespace {

// p_view at dist_view 1 through the texel's centre, straight from the camera's half angles.
glm::dvec3 towards(const Camera& camera, int x, int y) {
  const double ndc_x = 2.0 * (x + 0.5) / camera.size.width - 1.0;
  const double ndc_y = 1.0 - 2.0 * (y + 0.5) / camera.size.height;
  return {ndc_x / camera.clip_from_view[0][0], ndc_y / camera.clip_from_view[1][1], -1.0};
}

Surface floorAt(double height, double nearest_dist, double farthest_dist, bool is_mirror) {
  return {.normal_view = {0.0, 1.0, 0.0},
          .offset = -height,
          .is_mirror = is_mirror,
          .contains = [=](glm::dvec3 p) { return -p.z >= nearest_dist && -p.z <= farthest_dist; }};
}

Surface wallAt(double dist_view, bool is_mirror) {
  return {.normal_view = {0.0, 0.0, 1.0}, .offset = -dist_view, .is_mirror = is_mirror};
}

}  // namespace

Camera formulaCamera(Size size) {
  Camera camera;
  camera.size = size;
  camera.near_m = 0.1;
  camera.far_m = 1000.0;
  camera.clip_from_view =
      perspective(2.0 * std::atan(0.5), static_cast<double>(size.width) / size.height, 0.1, 1000.0);
  return camera;
}

AnalyticScene render(const Camera& camera, const std::vector<Surface>& surfaces) {
  AnalyticScene scene{.camera = camera,
                      .dist_view = Image(camera.size, {"Z"}),
                      .normal_view = Image(camera.size, {"X", "Y", "Z", "cosine"}),
                      .mask = Image(camera.size, {"mirror"})};
  for (int y = 0; y < camera.size.height; ++y) {
    for (int x = 0; x < camera.size.width; ++x) {
      const glm::dvec3 way = towards(camera, x, y);
      double nearest = kInfinity;
      for (const Surface& surface : surfaces) {
        const double dist = surface.offset / glm::dot(surface.normal_view, way);
        if (!(dist > 0.0 && dist < nearest) || !surface.contains(dist * way)) {
          continue;
        }
        nearest = dist;
        const double side = glm::dot(surface.normal_view, way) > 0.0 ? -1.0 : 1.0;
        for (int axis = 0; axis < 3; ++axis) {
          scene.normal_view.at(x, y, static_cast<std::size_t>(axis)) =
              static_cast<float>(side * surface.normal_view[axis]);
        }
        scene.normal_view.at(x, y, 3) = 1.0F;
        scene.mask.at(x, y) = surface.is_mirror ? 1.0F : 0.0F;
      }
      scene.dist_view.at(x, y) = static_cast<float>(nearest);
    }
  }
  return scene;
}

AnalyticScene flatScene(Size size) {
  return render(formulaCamera(size), {wallAt(5.0, true)});
}

AnalyticScene sceneM1(Size size) {
  return render(formulaCamera(size), {floorAt(1.0, 0.0, 8.0, true), wallAt(8.0, false)});
}

AnalyticScene sceneM2(Size size) {
  return render(formulaCamera(size), {floorAt(1.0, -100.0, 4.0, false), wallAt(4.0, true)});
}

AnalyticScene sceneM3(Size size) {
  Surface quad = wallAt(4.0, false);
  // Y from -.1 to .3 at dist_view 4 with f = 2.
  quad.contains = [](glm::dvec3 p) { return p.y >= -0.2 && p.y <= 0.6 && std::abs(p.x) <= 1.0; };
  return render(formulaCamera(size), {floorAt(1.0, 0.0, 8.0, true), wallAt(8.0, false), quad});
}

AnalyticScene sceneM4(Size size) {
  const double root_half = std::sqrt(0.5);
  const Surface mirror{
      .normal_view = {root_half, 0.0, root_half},
      .offset = -4.0 * root_half,
      .is_mirror = true,
      .contains = [](glm::dvec3 p) { return std::abs(p.y) <= 1.0 && p.x >= -1.0 && p.x <= 0.75; }};
  const Surface side_wall{.normal_view = {-1.0, 0.0, 0.0}, .offset = -1.0, .contains = [](glm::dvec3 p) {
                            return p.y >= -1.0 && p.y <= 3.0 && p.z >= -10.0 && p.z <= -2.0;
                          }};
  return render(formulaCamera(size),
                {mirror, side_wall, floorAt(1.0, -2.0, 10.0, false), wallAt(10.0, false)});
}

OracleResult trace(const AnalyticScene& scene, const TraceParameters& parameters, int thread_count) {
  Expected<OracleResult> result = traceOracle(scene.input(parameters), thread_count);
  if (!result) {
    ADD_FAILURE() << sentence(result.error());
    return {};
  }
  return *std::move(result);
}

}  // namespace ssrkit::testing
