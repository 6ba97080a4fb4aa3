#include "scene/tangents.h"

#include <cmath>

namespace ssrkit {

namespace {

glm::dvec3 anyPerpendicular(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(glm::cross(normal, axis), normal));
}

glm::vec4 orthonormal(const glm::dvec3& normal, const glm::dvec3& along_u, const glm::dvec3& along_v) {
  glm::dvec3 tangent = along_u - normal * glm::dot(normal, along_u);
  const double length = glm::length(tangent);
  tangent = length > 0.0 && std::isfinite(length) ? tangent / length : anyPerpendicular(normal);
  // v grows downwards in glTF and a normal map's green upwards, so the bitangent is against v.
  const double handedness = glm::dot(glm::cross(normal, tangent), along_v) > 0.0 ? -1.0 : 1.0;
  return {glm::vec3(tangent), static_cast<float>(handedness)};
}

}  // namespace

std::vector<glm::vec4> tangentsFromUv(std::span<const glm::vec3> positions,
                                      std::span<const glm::vec3> normals, std::span<const glm::vec2> uvs,
                                      std::span<const std::uint32_t> triangles) {
  std::vector<glm::dvec3> along_u(positions.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> along_v(positions.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const glm::dvec3 edge1 = glm::dvec3(positions[triangles[i + 1]]) - glm::dvec3(positions[triangles[i]]);
    const glm::dvec3 edge2 = glm::dvec3(positions[triangles[i + 2]]) - glm::dvec3(positions[triangles[i]]);
    const glm::dvec2 uv1 = glm::dvec2(uvs[triangles[i + 1]]) - glm::dvec2(uvs[triangles[i]]);
    const glm::dvec2 uv2 = glm::dvec2(uvs[triangles[i + 2]]) - glm::dvec2(uvs[triangles[i]]);
    const double determinant = uv1.x * uv2.y - uv2.x * uv1.y;
    if (determinant == 0.0) {
      continue;  // the triangle has no extent in the texture
    }
    // Dividing by the determinant's sign only weighs each triangle by its areas in space and in the texture.
    const double sign = determinant < 0.0 ? -1.0 : 1.0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      along_u[triangles[i + corner]] += sign * (edge1 * uv2.y - edge2 * uv1.y);
      along_v[triangles[i + corner]] += sign * (edge2 * uv1.x - edge1 * uv2.x);
    }
  }
  std::vector<glm::vec4> tangents(positions.size());
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    tangents[v] = orthonormal(glm::dvec3(normals[v]), along_u[v], along_v[v]);
  }
  return tangents;
}

}  // namespace ssrkit
