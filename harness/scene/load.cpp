#include "scene/load.h"

#include <fmt/format.h>

#include <memory>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "scene/defaults.h"
#include "scene/gltf_animations.h"
#include "scene/gltf_cameras.h"
#include "scene/gltf_document.h"
#include "scene/gltf_geometry.h"
#include "scene/gltf_lights.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_nodes.h"
#include "scene/mirrors.h"
#include "scene/motion.h"

namespace ssrkit {

namespace {

Expected<Scene> buildScene(GltfDocument& document, const std::string& camera_name,
                           const std::string& mirror_material) {
  Scene scene;
  SceneMotion motion;
  auto tree = readNodes(document);
  if (!tree) {
    return tl::make_unexpected(tree.error());
  }
  motion.tree = *std::move(tree);
  if (auto animated = readAnimations(document, motion.tree); !animated) {
    return tl::make_unexpected(animated.error());
  }
  const auto nodes = placeNodes(motion.tree, 0.0);
  if (!nodes) {
    return tl::make_unexpected(nodes.error());
  }
  auto materials = readMaterials(document);
  if (!materials) {
    return tl::make_unexpected(materials.error());
  }
  if (auto built = buildGeometry(document, *materials, *nodes, scene, motion.meshes); !built) {
    return tl::make_unexpected(built.error());
  }
  scene.materials = std::move(materials->materials);
  scene.textures = std::move(materials->textures);
  if (auto built = buildCameras(document, *nodes, camera_name, scene); !built) {
    return tl::make_unexpected(built.error());
  }
  buildLights(document, *nodes, scene);
  if (auto chosen = chooseMirrors(document.source, mirror_material, scene); !chosen) {
    return tl::make_unexpected(chosen.error());
  }
  if (!motion.tree.channels.empty()) {
    scene.motion = std::make_shared<const SceneMotion>(std::move(motion));
  }
  scene.notes.insert(scene.notes.begin(), document.notes.begin(), document.notes.end());
  for (std::string& note : notesOf(document.tally)) {
    scene.notes.push_back(std::move(note));
  }
  return scene;
}

// The defaults beside the scene; nothing when there is no such file.
Expected<std::optional<SceneDefaults>> defaultsBeside(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::path beside = defaultsFileOf(file);
  if (!std::filesystem::exists(beside, ignored)) {
    return std::nullopt;
  }
  return loadSceneDefaults(beside).map(
      [](SceneDefaults defaults) { return std::optional(std::move(defaults)); });
}

}  // namespace

Expected<Scene> loadScene(const std::filesystem::path& file, const SceneOptions& options) try {
  const GltfSource source{file};
  auto defaults = defaultsBeside(file);
  if (!defaults) {
    return tl::make_unexpected(defaults.error());
  }
  auto document = readGltfDocument(source);
  if (!document) {
    return tl::make_unexpected(document.error());
  }
  const bool own_camera = options.camera_name.empty() && defaults->has_value();
  auto scene =
      buildScene(*document, own_camera ? (*defaults)->camera : options.camera_name, options.mirror_material);
  if (!scene) {
    return scene;
  }
  scene->name = file.stem().string();
  if (defaults->has_value()) {
    applyLook(**defaults, *scene);
  }
  return scene;
} catch (const std::bad_alloc&) {
  return setupError("load the scene", "there is not enough memory for it", file.string());
}

}  // namespace ssrkit
