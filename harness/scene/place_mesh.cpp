#include "scene/place_mesh.h"

#include <cmath>
#include <optional>
#include <utility>

namespace ssrkit {

namespace {

// The vector with length 1, or nothing where it has none.
std::optional<glm::vec3> unit(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  if (length > 0.0 && std::isfinite(length)) {
    return glm::vec3(vector / length);
  }
  return std::nullopt;
}

// The normal of the face, nothing where the corners span no area.
std::optional<glm::dvec3> faceNormal(const glm::dvec3& edge1, const glm::dvec3& edge2) {
  const glm::dvec3 cross = glm::cross(edge1, edge2);
  // Below this sine of the angle between its edges a triangle is rounding of its corners.
  constexpr double kSmallestSine = 1e-9;
  const double area = glm::length(cross);
  if (!(area > kSmallestSine * glm::length(edge1) * glm::length(edge2))) {
    return std::nullopt;
  }
  return cross / area;
}

// Everything of a corner but its position.
Vertex placedSurface(const MeshTriangles& mesh, std::uint32_t corner, const MeshTransform& transform,
                     const glm::dvec3& face_normal, const glm::dvec3& edge, std::size_t& mended_normals) {
  Vertex vertex{};
  vertex.face_normal_world = glm::vec3(face_normal);
  vertex.normal_world = vertex.face_normal_world;
  if (!mesh.normals.empty()) {
    const auto normal = unit(transform.normals * glm::dvec3(mesh.normals[corner]));
    vertex.normal_world = normal.value_or(vertex.normal_world);
    mended_normals += normal ? 0U : 1U;
  }
  vertex.tangent_world = glm::vec4(1.0F, 0.0F, 0.0F, 1.0F);
  if (!mesh.tangents.empty()) {
    const glm::vec4& tangent = mesh.tangents[corner];
    const double side = (tangent.w < 0.0F ? -1.0 : 1.0) * transform.handedness;
    const auto direction = unit(transform.directions * glm::dvec3(tangent));
    vertex.tangent_world = glm::vec4(direction.value_or(unit(edge).value_or(glm::vec3(1, 0, 0))), side);
  }
  vertex.uv = mesh.uvs.empty() ? glm::vec2(0.0F) : mesh.uvs[corner];
  vertex.material_index = static_cast<float>(mesh.material_index);
  return vertex;
}

}  // namespace

MeshTransform::MeshTransform(const glm::dmat4& world_from_node)
    : positions(world_from_node), directions(world_from_node) {
  const glm::dmat3& m = directions;
  handedness = glm::dot(glm::cross(m[0], m[1]), m[2]) < 0.0 ? -1.0 : 1.0;
  normals = glm::dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])) * handedness;
}

glm::vec3 placedPosition(const MeshTriangles& mesh, std::uint32_t corner, const MeshTransform& transform) {
  return {transform.positions * glm::dvec4(mesh.positions[corner], 1.0)};
}

PlacedTriangle placeTriangle(const MeshTriangles& mesh, std::size_t first, const MeshTransform& transform,
                             std::size_t& mended_normals) {
  PlacedTriangle placed;
  placed.corners = {mesh.triangles[first], mesh.triangles[first + 1], mesh.triangles[first + 2]};
  if (transform.handedness < 0.0) {
    std::swap(placed.corners[1], placed.corners[2]);
  }
  std::array<glm::dvec3, 3> p_world;
  for (std::size_t c = 0; c < 3; ++c) {
    p_world[c] = glm::dvec3(placedPosition(mesh, placed.corners[c], transform));
  }
  const glm::dvec3 edge = p_world[1] - p_world[0];
  const auto normal = faceNormal(edge, p_world[2] - p_world[0]);
  placed.has_area = normal.has_value();
  for (std::size_t c = 0; c < 3; ++c) {
    placed.vertices[c] = placedSurface(mesh, placed.corners[c], transform,
                                       normal.value_or(glm::dvec3(0.0, 1.0, 0.0)), edge, mended_normals);
    placed.vertices[c].p_world = glm::vec3(p_world[c]);
    placed.vertices[c].p_previous_world = placed.vertices[c].p_world;
  }
  return placed;
}

}  // namespace ssrkit
