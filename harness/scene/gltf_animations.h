#pragma once

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/node_tree.h"

namespace ssrkit {

// Puts the file's animations into the tree. All of them play together; where two move the same property of a
// node, the first of the file does. Morph weights are left out. Rotations are normalised. Fails on samplers
// whose counts, times or values glTF does not allow, on a property that one animation moves twice, and on an
// animated node with a matrix.
[[nodiscard]] Expected<void> readAnimations(GltfDocument& document, NodeTree& tree);

}  // namespace ssrkit
