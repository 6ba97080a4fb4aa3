#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/scene.h"

namespace ssrkit {

// Where a material's textures take their coordinates from. The kit has one set a vertex, so all of a
// material's textures share that of its first one.
struct UvSource {
  int set = 0;                   // TEXCOORD_set
  glm::mat3 uv_from_file{1.0F};  // KHR_texture_transform
};

struct GltfMaterials {
  std::vector<Material> materials;   // the file's, then one for primitives that name none
  std::vector<UvSource> uv_sources;  // one a material
  std::vector<Texture> textures;
};

// The file's materials and the images they use, decoded. Unnamed ones are called "material N".
[[nodiscard]] Expected<GltfMaterials> readMaterials(GltfDocument& document);

}  // namespace ssrkit
