// What a scene is read from.
#pragma once

#include <filesystem>
#include <vector>

namespace ssrkit {

// Every file that loadScene would read for `scene_file`, each once and in order: itself, the buffers and
// pictures that it names, NAME.toml beside it and the environment that this one names. One that is named need
// not be there, and a file that cannot be understood names none: loading it says why.
[[nodiscard]] std::vector<std::filesystem::path> sceneFiles(const std::filesystem::path& scene_file);

}  // namespace ssrkit
