#include "oracle/drawn_triangles.h"

#include <algorithm>

#include "base/check.h"
#include "oracle/alpha_cutout.h"

namespace ssrkit {

DrawnTriangles::DrawnTriangles(const Scene& scene, const glm::dmat4& view_from_world)
    : view_from_world_(view_from_world) {
  cut_outs_.materials = scene.materials;
  bool has_cut_outs = false;
  for (const Material& material : scene.materials) {
    const bool is_cut_out = alphaCutoff(material) > 0.0F;
    has_cut_outs = has_cut_outs || is_cut_out;
    looks_.push_back({.is_double_sided = material.double_sided, .is_cut_out = is_cut_out});
  }
  if (has_cut_outs) {
    cut_outs_.textures = scene.textures;
  }
  const std::size_t triangle_count = scene.vertices.size() / 3;
  material_indices_.reserve(triangle_count);
  p_world_.reserve(3 * triangle_count);
  uvs_.reserve(has_cut_outs ? 3 * triangle_count : 0);
  for (std::size_t i = 0; i < 3 * triangle_count; ++i) {
    const Vertex& vertex = scene.vertices[i];
    p_world_.push_back(vertex.p_world);
    if (has_cut_outs) {
      uvs_.push_back(vertex.uv);
    }
    if (i % 3 == 0) {
      const int material = static_cast<int>(vertex.material_index);
      SSRKIT_CHECK_LT(static_cast<std::size_t>(material), looks_.size());
      material_indices_.push_back(material);
    }
  }
}

std::array<glm::dvec3, 3> DrawnTriangles::corners(std::size_t triangle) const {
  std::array<glm::dvec3, 3> views;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const glm::dvec3 world(p_world_[3 * triangle + corner]);
    views.at(corner) = glm::dvec3(view_from_world_ * glm::dvec4(world, 1.0));
  }
  return views;
}

bool DrawnTriangles::isThere(std::size_t triangle, const glm::dvec3& face_normal, const glm::dvec3& dir_view,
                             float u, float v) const {
  const auto material = static_cast<std::size_t>(material_indices_[triangle]);
  if (!looks_[material].is_double_sided && glm::dot(face_normal, dir_view) > 0.0) {
    return false;
  }
  if (!looks_[material].is_cut_out) {
    return true;
  }
  const glm::vec2* const uv = &uvs_[3 * triangle];
  return isDrawnAt(cut_outs_, cut_outs_.materials[material], (1.0F - u - v) * uv[0] + u * uv[1] + v * uv[2]);
}

bool DrawnTriangles::isLeftBy(const SurfaceRay& ray, const std::array<glm::dvec3, 3>& corner,
                              const glm::dvec3& face_normal) const {
  // The normal on the camera's side of the plane; the camera is the origin.
  const glm::dvec3 normal = glm::dot(face_normal, corner[0]) > 0.0 ? -face_normal : face_normal;
  if (!(glm::dot(normal, ray.dir_view) > 0.0)) {
    return false;
  }
  const glm::dvec3 along_error = glm::abs(normal * ray.origin_error);
  const double error_m = along_error.x + along_error.y + along_error.z;
  if (!(error_m > 0.0)) {
    return false;
  }
  // The rasteriser places vertices in single precision, a few units in the last place of their distances.
  constexpr double kSingleUlps = 4.0 / (1 << 24);
  double reach_m = glm::length(glm::dvec3(view_from_world_[3]));
  for (const glm::dvec3& p_view : corner) {
    reach_m = std::max(reach_m, glm::length(p_view));
  }
  return glm::dot(normal, corner[0] - ray.origin_view) <= error_m + kSingleUlps * reach_m;
}

}  // namespace ssrkit
