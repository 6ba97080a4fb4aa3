// Built-in scenes by name, other scenes by path.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace ssrkit {

// The names of the built-in scenes that are in `scenes_root` (as NAME/NAME.gltf), the closed-form ones first.
[[nodiscard]] std::vector<std::string> builtInScenes(const std::filesystem::path& scenes_root);

// The file of a built-in scene, or `name_or_path` itself when it is a file. A built-in name wins over a file
// of that name in the working folder ("./clutter" names the file). Fails with the nearest name and the list.
[[nodiscard]] Expected<std::filesystem::path> findScene(std::string_view name_or_path,
                                                        const std::filesystem::path& scenes_root);

}  // namespace ssrkit
