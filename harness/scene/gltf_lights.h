#pragma once

#include <span>

#include "scene/gltf_document.h"
#include "scene/gltf_nodes.h"
#include "scene/scene.h"

namespace ssrkit {

// KHR_lights_punctual of the placed nodes into the scene. A scene without a directional light gets one (a
// faint one beside point lights), with a note. Lights far too bright for an image without exposure, as
// physical units often are, are scaled down together, with a note. Needs the scene's triangles.
void buildLights(const GltfDocument& document, std::span<const PlacedNode> nodes, Scene& scene);

}  // namespace ssrkit
