#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_nodes.h"
#include "scene/motion.h"
#include "scene/scene.h"

namespace ssrkit {

// Every mesh of the placed nodes as world-space triangles in `scene.vertices`, with one draw range for each
// set of textures, with and without an alpha cutoff, in the order in which the file first uses it; those of
// moving nodes are listed in `moving` too. Fails without a triangle and above kMaxVertices.
[[nodiscard]] Expected<void> buildGeometry(GltfDocument& document, const GltfMaterials& materials,
                                           std::span<const PlacedNode> nodes, Scene& scene,
                                           std::vector<MovingMesh>& moving);

}  // namespace ssrkit
