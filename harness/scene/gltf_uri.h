#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace ssrkit {

// The bytes behind a URI of a glTF file: a base64 data: URI, or a file in the glTF file's own folder or below
// it. Absolute paths, "..", other schemes and links that lead out of the folder are refused: a scene from the
// net must not read the user's files.
[[nodiscard]] Expected<std::vector<std::uint8_t>> readGltfUri(const GltfSource& source,
                                                              const std::string& uri,
                                                              const std::string& place);

}  // namespace ssrkit
