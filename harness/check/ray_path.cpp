#include "check/ray_path.h"

#include <cmath>

namespace ssrkit {

namespace {

glm::dvec2 project(const PixelProjection& projection, const glm::dvec3& p_view) {
  return projection.px_scale * (glm::dvec2(p_view) / -p_view.z) + projection.px_offset;
}

}  // namespace

int RayPath::primaryAxis() const { return std::abs(slope_px.x) >= std::abs(slope_px.y) ? 0 : 1; }

glm::dvec2 RayPath::atDistance(double t_m) const { return project(projection, origin_view + t_m * dir_view); }

RayPath rayPath(const OracleInput& input, int x, int y) {
  RayPath path;
  path.projection = pixelProjection(*input.camera);
  const double dist_view = static_cast<double>(input.dist_view->at(x, y));
  const glm::dvec2 centre_px(x + 0.5, y + 0.5);
  const glm::dvec2 xy_view =
      dist_view * (centre_px - path.projection.px_offset) / path.projection.px_scale;
  const glm::dvec3 surface_view(xy_view, -dist_view);
  const Image& normals = *input.normal_view;
  const glm::dvec3 normal_view(normals.at(x, y, 0), normals.at(x, y, 1), normals.at(x, y, 2));
  path.dir_view = glm::normalize(glm::reflect(glm::normalize(surface_view), normal_view));
  path.origin_view = surface_view + input.parameters.origin_bias * dist_view * normal_view;
  path.origin_px = project(path.projection, path.origin_view);
  // d(p_view.xy / dist_view)/dt without its positive factor 1/dist_view^2: the line's heading is constant.
  path.slope_px = path.projection.px_scale * (glm::dvec2(path.dir_view) * -path.origin_view.z +
                                              glm::dvec2(path.origin_view) * path.dir_view.z);
  return path;
}

}  // namespace ssrkit
