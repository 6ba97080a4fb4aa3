#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/error.h"
#include "scene/gltf_document.h"

namespace ssrkit {

struct PlacedNode {
  int node = 0;  // index in the file
  glm::dmat4 world_from_node{1.0};
};

// The nodes of the file's scene (its default one, else the first, else every root) with their places in the
// world, in the order of the file's lists. Fails on cycles, on a node with two parents and on transforms that
// are not finite. Notes scenes that are not drawn.
[[nodiscard]] Expected<std::vector<PlacedNode>> placeNodes(GltfDocument& document);

}  // namespace ssrkit
