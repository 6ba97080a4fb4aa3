#pragma once

#include <span>
#include <string>

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/gltf_nodes.h"
#include "scene/scene.h"

namespace ssrkit {

// The perspective cameras of the placed nodes into `scene.cameras`, the one called `camera_name` first ("":
// the order of the file). Frames one, with a note, when the file has none. Orthographic cameras are left out
// with a note, and refused when there is no other or when one is asked for. Needs the scene's triangles.
[[nodiscard]] Expected<void> buildCameras(GltfDocument& document, std::span<const PlacedNode> nodes,
                                          const std::string& camera_name, Scene& scene);

}  // namespace ssrkit
