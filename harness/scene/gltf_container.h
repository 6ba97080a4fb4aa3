#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace ssrkit {

// What a .gltf or .glb file holds: its JSON text and, in a .glb, the binary chunk.
struct GltfContainer {
  std::string json_text;
  std::vector<std::uint8_t> binary;
  bool has_binary = false;
};

// Reads and takes apart the file; which of the two it is, is told by its content, not by its name.
[[nodiscard]] Expected<GltfContainer> readGltfContainer(const GltfSource& source);

}  // namespace ssrkit
