// Where the built-in scenes are.
#pragma once

#include <filesystem>

namespace ssrkit {

inline const std::filesystem::path kScenes = std::filesystem::path(SSRKIT_SOURCE_DIR) / "scenes";

}  // namespace ssrkit
