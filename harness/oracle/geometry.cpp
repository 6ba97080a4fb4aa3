#include "oracle/geometry.h"

#include <cmath>
#include <limits>
#include <vector>

#include "base/check.h"
#include "base/share_out.h"
#include "oracle/image_ray.h"

namespace ssrkit {

namespace {

// How well a rasteriser's dist_view and pixel positions agree with the true ones (docs/precision.md).
constexpr double kDepthRelative = 5e-6;
constexpr double kDepthPx = 1e-3;

// Through the point p_px at dist_view 1.
glm::dvec3 towards(const PixelProjection& projection, glm::dvec2 p_px) {
  return {(p_px - projection.px_offset) / projection.px_scale, -1.0};
}

SurfaceRay surfaceRay(const OracleInput& input, const PixelProjection& projection, const PixelRay& pixel,
                      int x, int y) {
  const double dist = input.dist_view->at(x, y);
  SurfaceRay ray;
  ray.origin_view = pixel.origin_view;
  ray.dir_view = pixel.dir_view;
  ray.max_t_m = input.parameters.max_distance_m;
  ray.origin_error[0] = kDepthRelative * dist * towards(projection, {x + 0.5, y + 0.5});
  ray.origin_error[1] = {kDepthPx * dist / projection.px_scale.x, 0.0, 0.0};
  ray.origin_error[2] = {0.0, kDepthPx * dist / projection.px_scale.y, 0.0};
  return ray;
}

// Of the plane through p_view, whose dist_view is over 0. On it 1/dist_view = n . w(p_px) / (n . p_view) with
// w(p_px) = towards(p_px). Seen edge-on, n . p_view is 0 and the slope infinite: any depth agrees with it.
PlaneInImage planeInImage(const PixelProjection& projection, const glm::dvec3& p_view,
                          const glm::dvec3& normal_view) {
  PlaneInImage plane;
  plane.px = projection.px_scale * glm::dvec2(p_view) / -p_view.z + projection.px_offset;
  plane.inv_dist = -1.0 / p_view.z;
  plane.inv_dist_per_px = glm::dvec2(normal_view) / projection.px_scale / glm::dot(normal_view, p_view);
  return plane;
}

bool isInFrustum(const Camera& camera, const TrueRay& ray) {
  const glm::dvec2 px = ray.plane.px;
  return ray.dist_view >= camera.near_m && ray.dist_view <= camera.far_m && px.x >= 0.0 && px.y >= 0.0 &&
         px.x < camera.size.width && px.y < camera.size.height;
}

// Whether something that is drawn stands between the camera and p_view.
bool isHidden(const Camera& camera, const TrueSurfaces& surfaces, const glm::dvec3& p_view) {
  const double length = glm::length(p_view);
  // The point's own surface is met there to this part of the distance.
  constexpr double kOwn = 1e-6;
  const auto nearest = surfaces.firstHit({.origin_view = glm::dvec3(0.0),
                                          .dir_view = p_view / length,
                                          .min_t_m = camera.near_m * length / -p_view.z,
                                          .max_t_m = length});
  return nearest && nearest->t_m < (1.0 - kOwn) * length;
}

TrueClass classOf(const OracleInput& input, const PixelProjection& projection, const TrueSurfaces& surfaces,
                  const TrueRay& ray, const glm::dvec3& p_view, const glm::dvec3& normal_view) {
  if (!isInFrustum(*input.camera, ray)) {
    return TrueClass::kOffscreen;
  }
  if (glm::dot(normal_view, p_view) > 0.0) {
    return TrueClass::kBackface;
  }
  const glm::ivec2 texel(ray.plane.px);
  if (holdsSurface(ray.plane, projection, *input.dist_view, texel.x, texel.y)) {
    return TrueClass::kVisible;
  }
  return isHidden(*input.camera, surfaces, p_view) ? TrueClass::kOccluded : TrueClass::kUnsampled;
}

TrueRay trueRay(const OracleInput& input, const PixelProjection& projection, const TrueSurfaces& surfaces,
                int x, int y) {
  TrueRay result;
  const PixelRay pixel = pixelRay(input, projection, x, y);
  if (!pixel.is_reflected) {
    return result;
  }
  const auto hit = surfaces.firstHit(surfaceRay(input, projection, pixel, x, y));
  if (!hit) {
    result.true_class = TrueClass::kSky;
    return result;
  }
  const glm::dvec3 p_view = pixel.origin_view + hit->t_m * pixel.dir_view;
  result.t_m = hit->t_m;
  result.dist_view = -p_view.z;
  if (result.dist_view > 0.0) {
    result.plane = planeInImage(projection, p_view, hit->normal_view);
  }
  result.true_class = classOf(input, projection, surfaces, result, p_view, hit->normal_view);
  return result;
}

}  // namespace

bool holdsSurface(const PlaneInImage& plane, const PixelProjection& projection, const Image& dist_view, int x,
                  int y) {
  const glm::dvec2 to_centre = glm::dvec2(x + 0.5, y + 0.5) - plane.px;
  const double expected = plane.inv_dist + glm::dot(plane.inv_dist_per_px, to_centre);
  const double actual = 1.0 / static_cast<double>(dist_view.at(x, y));
  const double half_slope = 0.5 * (std::abs(plane.inv_dist_per_px.x) + std::abs(plane.inv_dist_per_px.y));
  const double half_width = 0.5 / std::abs(projection.px_scale.y);
  return std::abs(actual - expected) <= half_slope + (half_width + kDepthRelative) * plane.inv_dist;
}

Expected<GeometryResult> traceGeometry(const OracleInput& input, const TrueSurfaces& surfaces,
                                       int thread_count) {
  if (Expected<void> checked = checkInput(input); !checked) {
    return tl::make_unexpected(checked.error());
  }
  SSRKIT_CHECK(surfaces.viewFromWorld() == input.camera->view_from_world);
  const PixelProjection projection = pixelProjection(*input.camera);
  const Size size = input.camera->size;
  GeometryResult result(size);
  forEachInParallel(size.height, thread_count, [&](int y) {
    std::vector<TrueRay> row;
    row.reserve(static_cast<std::size_t>(size.width));
    for (int x = 0; x < size.width; ++x) {
      row.push_back(trueRay(input, projection, surfaces, x, y));
    }
    result.setRow(y, row);
  });
  return result;
}

Image trueDistView(const Camera& camera, const TrueSurfaces& surfaces, int thread_count) {
  const PixelProjection projection = pixelProjection(camera);
  Image dist_view(camera.size, {"Z"});
  forEachInParallel(camera.size.height, thread_count, [&](int y) {
    for (int x = 0; x < camera.size.width; ++x) {
      const glm::dvec3 way = towards(projection, {x + 0.5, y + 0.5});
      const double metres_per_dist = glm::length(way);
      const auto hit = surfaces.firstHit({.origin_view = glm::dvec3(0.0),
                                          .dir_view = way / metres_per_dist,
                                          .min_t_m = camera.near_m * metres_per_dist,
                                          .max_t_m = camera.far_m * metres_per_dist});
      dist_view.at(x, y) =
          hit ? static_cast<float>(hit->t_m / metres_per_dist) : std::numeric_limits<float>::infinity();
    }
  });
  return dist_view;
}

}  // namespace ssrkit
