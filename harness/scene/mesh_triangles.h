#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ssrkit {

// One primitive of a mesh, in the mesh's own space.
struct MeshTriangles {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;        // empty: flat
  std::vector<glm::vec4> tangents;       // empty: not needed
  std::vector<glm::vec2> uvs;            // empty: none
  std::vector<std::uint32_t> triangles;  // three indices each
  int material_index = 0;
};

}  // namespace ssrkit
