#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/gltf_materials.h"

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

// Reads meshes[mesh].primitives[primitive]; no triangles come from points and lines. Fails on accessors that
// do not fit and on positions that are not finite.
[[nodiscard]] Expected<MeshTriangles> readPrimitive(GltfDocument& document, const GltfMaterials& materials,
                                                    int mesh, int primitive);

}  // namespace ssrkit
