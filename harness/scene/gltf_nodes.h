#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/node_tree.h"

namespace ssrkit {

struct PlacedNode {
  int node = 0;        // index in the file
  int tree_node = -1;  // index in the scene's tree, -1: it stands still
  glm::dmat4 world_from_node{1.0};
};

// The nodes of the file's scene (its default one, else the first, else every root), in the order of the
// file's lists, without their animation. Fails on cycles and on a node with two parents. Notes scenes that
// are not drawn.
[[nodiscard]] Expected<NodeTree> readNodes(GltfDocument& document);

// The tree's nodes with their places in the world at a time. Fails on transforms that are not finite.
[[nodiscard]] Expected<std::vector<PlacedNode>> placeNodes(const NodeTree& tree, double time_s);

}  // namespace ssrkit
