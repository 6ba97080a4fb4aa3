#include "oracle/image_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ssrkit {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PixelRay early(RayClass ray_class, bool is_tie = false) {
  PixelRay result;
  result.early_class = ray_class;
  result.is_start_tie = is_tie;
  return result;
}

glm::dvec3 normalAt(const Image& normal_view, int x, int y) {
  return glm::normalize(
      glm::dvec3(normal_view.at(x, y, 0), normal_view.at(x, y, 1), normal_view.at(x, y, 2)));
}

// Where the ray reaches max_distance_m, or its vanishing point when that is infinite.
double sigmaOfRange(double dist_origin, double dist_per_m, double max_distance_m) {
  if (std::isinf(max_distance_m)) {
    return dist_per_m > 0.0 ? 1.0 / dist_per_m : kInfinity;
  }
  const double dist = dist_origin + max_distance_m * dist_per_m;
  return dist > 0.0 ? max_distance_m / dist : kInfinity;
}

double sigmaOfNearPlane(double dist_origin, double dist_per_m, double near_m) {
  return dist_per_m < 0.0 ? (1.0 - dist_origin / near_m) / dist_per_m : kInfinity;
}

double sigmaOfImageEdge(const ImageRay& ray, Size size) {
  const glm::dvec2 far_corner(size.width, size.height);
  double sigma = kInfinity;
  for (int axis = 0; axis < 2; ++axis) {
    if (ray.moves(axis)) {
      sigma = std::min(sigma, ray.sigmaAt(axis, ray.px_per_sigma[axis] > 0.0 ? far_corner[axis] : 0.0));
    }
  }
  return sigma;
}

ImageRay project(const PixelProjection& projection, glm::dvec2 px_origin, glm::dvec3 origin_view,
                 glm::dvec3 dir_view) {
  ImageRay ray;
  const double dist_origin = -origin_view.z;
  const double dist_per_m = -dir_view.z;
  ray.px_origin = px_origin;
  ray.px_per_sigma = projection.px_scale *
                     (glm::dvec2(dir_view) * dist_origin - glm::dvec2(origin_view) * dist_per_m) /
                     dist_origin;
  for (int axis = 0; axis < 2; ++axis) {
    // Below this the reciprocal overflows; no image is large enough to see such a motion.
    if (std::abs(ray.px_per_sigma[axis]) < 1e-300) {
      ray.px_per_sigma[axis] = 0.0;
    }
    ray.sigma_per_px[axis] = ray.moves(axis) ? 1.0 / ray.px_per_sigma[axis] : kInfinity;
  }
  ray.inv_dist_origin = 1.0 / dist_origin;
  ray.inv_dist_per_sigma = -dist_per_m / dist_origin;
  return ray;
}

// Ends the ray at the first of range, near plane and image edge, and tells whether two classes of end are a
// tie.
bool setEnd(ImageRay& ray, const OracleInput& input, double dist_origin, double dist_per_m) {
  const double range = sigmaOfRange(dist_origin, dist_per_m, input.parameters.max_distance_m);
  const double near_plane = sigmaOfNearPlane(dist_origin, dist_per_m, input.camera->near_m);
  const double edge = sigmaOfImageEdge(ray, input.camera->size);
  const double offscreen = std::min(near_plane, edge);
  ray.end_class = range < offscreen ? RayClass::kRange : RayClass::kOffscreen;
  ray.sigma_end = std::min(range, offscreen);
  if (std::isinf(range)) {
    return false;
  }
  // The near plane and the range are both planes or spheres in space: how near they are in the image says
  // nothing.
  const bool near_tie = std::abs(near_plane - range) <= kTieRelative * range && near_plane <= edge;
  const bool edge_tie =
      std::abs(edge - range) * glm::length(ray.px_per_sigma) <= kTiePx && edge <= near_plane;
  return near_tie || edge_tie;
}

bool isNearImageEdge(glm::dvec2 px, Size size) {
  const auto is_near = [](double position, double length) {
    return std::abs(position) <= kTiePx || std::abs(position - length) <= kTiePx;
  };
  return is_near(px.x, size.width) || is_near(px.y, size.height);
}

// Half-open: a point on the right or lower edge lies in no texel.
bool isInside(glm::dvec2 px, Size size) {
  return px.x >= 0.0 && px.y >= 0.0 && px.x < size.width && px.y < size.height;
}

struct Reflection {
  glm::dvec3 p_view{0.0};
  glm::dvec3 normal_view{0.0};
  glm::dvec3 dir_view{0.0};
  double cosine = 0.0;  // between dir_view and normal_view
};

Reflection reflectAt(const OracleInput& input, const PixelProjection& projection, int x, int y) {
  const glm::dvec2 px_centre(x + 0.5, y + 0.5);
  const glm::dvec3 towards((px_centre - projection.px_offset) / projection.px_scale, -1.0);
  const glm::dvec3 incident = glm::normalize(towards);
  Reflection reflection;
  reflection.p_view = static_cast<double>(input.dist_view->at(x, y)) * towards;
  reflection.normal_view = normalAt(*input.normal_view, x, y);
  reflection.dir_view = incident - 2.0 * glm::dot(reflection.normal_view, incident) * reflection.normal_view;
  reflection.cosine = glm::dot(reflection.dir_view, reflection.normal_view);
  return reflection;
}

PixelRay rayFrom(const OracleInput& input, const PixelProjection& projection, glm::dvec2 px_centre,
                 const Reflection& reflection) {
  const double bias = input.parameters.origin_bias;
  const double near_m = input.camera->near_m;
  const Size size = input.camera->size;
  const glm::dvec3 origin_view = reflection.p_view - bias * reflection.p_view.z * reflection.normal_view;
  const double dist_origin = -origin_view.z;
  const bool near_tie = std::abs(dist_origin - near_m) <= kTieRelative * near_m;
  PixelRay result = early(RayClass::kOffscreen, near_tie);
  result.is_reflected = true;
  result.origin_view = origin_view;
  result.dir_view = reflection.dir_view;
  if (!(dist_origin >= near_m)) {
    return result;
  }
  const glm::dvec2 px_origin =
      bias == 0.0 ? px_centre
                  : projection.px_scale * glm::dvec2(origin_view) / dist_origin + projection.px_offset;
  const bool edge_tie = bias != 0.0 && isNearImageEdge(px_origin, size);
  if (!isInside(px_origin, size)) {
    result.is_start_tie = edge_tie;
    return result;
  }
  result.is_walked = true;
  result.is_start_tie = near_tie || edge_tie || std::abs(reflection.cosine) < kTieCosine;
  result.ray = project(projection, px_origin, origin_view, reflection.dir_view);
  result.is_end_tie = setEnd(result.ray, input, dist_origin, -reflection.dir_view.z);
  return result;
}

}  // namespace

PixelRay pixelRay(const OracleInput& input, const PixelProjection& projection, int x, int y) {
  if (!(input.dist_view->at(x, y) < std::numeric_limits<float>::infinity())) {
    return early(RayClass::kBackground);
  }
  if (input.mask != nullptr && input.mask->at(x, y) == 0.0F) {
    return early(RayClass::kMasked);
  }
  if (input.normal_view->channelCount() > 3 && input.normal_view->at(x, y, 3) < 0.0F) {
    return early(RayClass::kIntoSurface);
  }
  const Reflection reflection = reflectAt(input, projection, x, y);
  if (!(reflection.cosine >= 0.0)) {
    return early(RayClass::kIntoSurface, std::abs(reflection.cosine) < kTieCosine);
  }
  return rayFrom(input, projection, {x + 0.5, y + 0.5}, reflection);
}

}  // namespace ssrkit
