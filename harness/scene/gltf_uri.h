#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace ssrkit {

// Whether the URI holds its bytes itself.
[[nodiscard]] bool isDataUri(std::string_view uri);

// The file that a URI of a glTF file names: one in the glTF file's own folder or below it, which need not be
// there. Absolute paths, "..", other schemes and links that lead out of the folder are refused: a scene from
// the net must not read the user's files.
[[nodiscard]] Expected<std::filesystem::path> gltfUriFile(const GltfSource& source, const std::string& uri,
                                                          const std::string& place);

// The bytes behind a URI of a glTF file: of a base64 data: URI, or of the file that it names.
[[nodiscard]] Expected<std::vector<std::uint8_t>> readGltfUri(const GltfSource& source,
                                                              const std::string& uri,
                                                              const std::string& place);

}  // namespace ssrkit
