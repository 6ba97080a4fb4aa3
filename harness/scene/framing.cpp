#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace ssrkit {

BoundingSphere boundingSphere(const Scene& scene) {
  glm::dvec3 lowest(std::numeric_limits<double>::max());
  glm::dvec3 highest(std::numeric_limits<double>::lowest());
  for (const Vertex& vertex : scene.vertices) {
    lowest = glm::min(lowest, glm::dvec3(vertex.p_world));
    highest = glm::max(highest, glm::dvec3(vertex.p_world));
  }
  BoundingSphere sphere;
  if (scene.vertices.empty()) {
    return sphere;
  }
  sphere.centre = 0.5 * (lowest + highest);
  for (const Vertex& vertex : scene.vertices) {
    sphere.radius_m = std::max(sphere.radius_m, glm::distance(sphere.centre, glm::dvec3(vertex.p_world)));
  }
  return sphere;
}

SceneCamera framedCamera(const BoundingSphere& sphere) {
  constexpr double kMargin = 1.05;
  SceneCamera camera;
  camera.name = "framed";
  camera.fov_y_rad = glm::quarter_pi<double>();
  const double radius = std::max(sphere.radius_m, 1e-6);
  const double distance = kMargin * radius / std::sin(0.5 * camera.fov_y_rad);
  const glm::dvec3 towards_camera = glm::normalize(glm::dvec3(0.6, 0.45, 1.0));
  camera.view_from_world =
      glm::lookAt(sphere.centre + distance * towards_camera, sphere.centre, glm::dvec3(0.0, 1.0, 0.0));
  camera.previous_view_from_world = camera.view_from_world;
  camera.near_m = 0.5 * (distance - radius);
  camera.far_m = 1.5 * (distance + radius);
  return camera;
}

double farBehindScene(const Scene& scene, const SceneCamera& camera) {
  const BoundingSphere sphere = boundingSphere(scene);
  const glm::dvec3 centre_view(camera.view_from_world * glm::dvec4(sphere.centre, 1.0));
  return std::max(1.1 * (sphere.radius_m - centre_view.z), 100.0 * camera.near_m);
}

}  // namespace ssrkit
