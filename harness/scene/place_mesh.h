// Triangles of a mesh put into the world.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "scene/mesh_triangles.h"
#include "scene/scene.h"

namespace ssrkit {

// Mesh to world: positions by the matrix, normals by its cofactors, which is the inverse transpose without
// the division that a flattened mesh would not survive.
struct MeshTransform {
  glm::dmat4 positions;
  glm::dmat3 directions;
  glm::dmat3 normals;
  double handedness = 1.0;  // -1: the transform mirrors, so corners and bitangents change sides

  explicit MeshTransform(const glm::dmat4& world_from_node);
};

[[nodiscard]] glm::vec3 placedPosition(const MeshTriangles& mesh, std::uint32_t corner,
                                       const MeshTransform& transform);

struct PlacedTriangle {
  std::array<std::uint32_t, 3> corners{};  // of the mesh, counter-clockwise in the world
  std::array<Vertex, 3> vertices{};
  bool has_area = false;  // without, the face's normal is +y
};

// The triangle of mesh.triangles[first ..]. `mended_normals` counts normals of no length, which become the
// face's own.
[[nodiscard]] PlacedTriangle placeTriangle(const MeshTriangles& mesh, std::size_t first,
                                           const MeshTransform& transform, std::size_t& mended_normals);

}  // namespace ssrkit
