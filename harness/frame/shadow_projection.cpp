#include "frame/shadow_projection.h"

#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

constexpr double kSliceRatio = 8.0;        // of the ends of two slices
constexpr double kFirstSliceM = 8.0;       // the first slice ends no farther away, where the count allows
constexpr double kSmallestExtentM = 1e-6;  // a scene that is a point still has a map

glm::dmat3 lightFromWorldRotation(const glm::dvec3& direction) {
  const glm::dvec3 up = std::abs(direction.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 right = glm::normalize(glm::cross(direction, up));
  return glm::transpose(glm::dmat3(right, glm::cross(direction, right), direction));
}

WorldBounds rotated(const WorldBounds& bounds, const glm::dmat3& rotation) {
  const glm::dvec3 centre = rotation * (0.5 * (bounds.least + bounds.greatest));
  const glm::dvec3 half = 0.5 * (bounds.greatest - bounds.least);
  glm::dvec3 extent(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    extent += glm::abs(rotation[axis]) * half[axis];
  }
  return {centre - extent, centre + extent};
}

struct Sphere {
  glm::dvec3 centre_view{0.0};
  double radius_m = 0.0;
};

// The smallest sphere around the frustum between two distances whose centre is on the viewing axis.
Sphere sliceSphere(const Camera& camera, double from_m, double to_m) {
  const glm::dmat4& p = camera.clip_from_view;
  // Largest x / dist and y / dist that the image shows.
  const glm::dvec2 slope((1.0 + std::abs(p[2][0])) / std::abs(p[0][0]),
                         (1.0 + std::abs(p[2][1])) / std::abs(p[1][1]));
  const double k2 = glm::dot(slope, slope);
  const double centre_m = std::min(0.5 * (from_m + to_m) * (1.0 + k2), to_m);
  const double to_near = std::hypot(centre_m - from_m, from_m * std::sqrt(k2));
  const double to_far = std::hypot(to_m - centre_m, to_m * std::sqrt(k2));
  return {{0.0, 0.0, -centre_m}, std::max(to_near, to_far)};
}

// A square of `side` texels that covers, along each axis, the scene or the sphere.
ShadowCascade fitCascade(const glm::dvec2& sphere_centre, double radius_m, const WorldBounds& scene) {
  const glm::dvec2 scene_extent = glm::dvec2(scene.greatest) - glm::dvec2(scene.least);
  const glm::dvec2 wanted = glm::min(scene_extent, glm::dvec2(2.0 * radius_m));
  const double extent_m = std::max({wanted.x, wanted.y, kSmallestExtentM});
  // One texel more for the corner's rounding.
  const double texel_m = extent_m / (kShadowSideTexels - 2 * kShadowMarginTexels - 1);
  const glm::dvec2 middle = 0.5 * glm::dvec2(scene.least + scene.greatest);
  const glm::dvec2 room = glm::max(0.5 * (scene_extent - extent_m), glm::dvec2(0.0));
  const glm::dvec2 centre = glm::clamp(sphere_centre, middle - room, middle + room);
  const glm::dvec2 corner = centre - 0.5 * extent_m;
  return {(glm::floor(corner / texel_m) - static_cast<double>(kShadowMarginTexels)) * texel_m, texel_m};
}

}  // namespace

WorldBounds worldBounds(const Scene& scene) {
  if (scene.vertices.empty()) {
    return {};
  }
  WorldBounds bounds{glm::dvec3(scene.vertices.front().p_world), glm::dvec3(scene.vertices.front().p_world)};
  for (const Vertex& vertex : scene.vertices) {
    bounds.least = glm::min(bounds.least, glm::dvec3(vertex.p_world));
    bounds.greatest = glm::max(bounds.greatest, glm::dvec3(vertex.p_world));
  }
  return bounds;
}

ShadowProjection fitShadow(const glm::dvec3& direction_world, const WorldBounds& scene,
                           const Camera& camera) {
  const glm::dmat3 rotation = lightFromWorldRotation(direction_world);
  const WorldBounds in_light = rotated(scene, rotation);
  ShadowProjection fit;
  fit.light_from_world = glm::dmat4(rotation);
  // A little room, so that rounding clips nothing.
  const double depth_m = std::max(in_light.greatest.z - in_light.least.z, kSmallestExtentM);
  fit.near_m = in_light.least.z - 0.001 * depth_m;
  fit.range_m = 1.002 * depth_m;
  // No two points of the scene are farther apart, so inside of it nothing is farther away.
  const double scene_m = std::clamp(glm::length(scene.greatest - scene.least), camera.near_m, camera.far_m);
  std::vector<double> ends_m = {camera.far_m};
  for (double end_m = scene_m; ends_m.size() < kShadowMaxCascades && end_m > kFirstSliceM;) {
    end_m /= kSliceRatio;
    ends_m.push_back(std::max(end_m, camera.near_m));
  }
  std::ranges::reverse(ends_m);
  const glm::dmat4 light_from_view = fit.light_from_world * glm::inverse(camera.view_from_world);
  double from_m = camera.near_m;
  for (const double to_m : ends_m) {
    const Sphere sphere = sliceSphere(camera, from_m, to_m);
    const glm::dvec2 centre(light_from_view * glm::dvec4(sphere.centre_view, 1.0));
    fit.cascades.push_back(fitCascade(centre, sphere.radius_m, in_light));
    from_m = to_m;
  }
  return fit;
}

}  // namespace ssrkit
