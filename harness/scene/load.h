// glTF 2.0 files (.gltf and .glb) as scenes.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "scene/scene.h"

namespace ssrkit {

struct SceneOptions {
  std::string mirror_material;  // the one material that mirrors; "": the scene's own mirrors
  std::string camera_name;      // moved to the front of Scene::cameras; "": the order of the file
};

// The whole scene of a file, checked before use: nothing in the file can make a later stage read out of
// bounds. NAME.toml beside NAME.gltf (scene/defaults.h) may set its light, sky and first camera. Whatever is
// defaulted or left out becomes a note. Fails on a file that is missing, malformed, over the limits of
// docs/formats.md, without a triangle, or that needs an extension the kit has not; the error names the place
// in the file.
[[nodiscard]] Expected<Scene> loadScene(const std::filesystem::path& file, const SceneOptions& options = {});

}  // namespace ssrkit
