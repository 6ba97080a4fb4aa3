#include "scene/mirrors.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "scene/clean_name.h"

namespace ssrkit {

namespace {

// The materials that some triangle has.
std::vector<bool> usedMaterials(const Scene& scene) {
  std::vector<bool> used(scene.materials.size(), false);
  for (const Vertex& vertex : scene.vertices) {
    used[static_cast<std::size_t>(vertex.material_index)] = true;
  }
  return used;
}

tl::unexpected<Error> unknownMaterial(const GltfSource& source, const std::string& name, const Scene& scene) {
  const std::vector<bool> used = usedMaterials(scene);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] && std::find(names.begin(), names.end(), scene.materials[i].name) == names.end()) {
      names.push_back(scene.materials[i].name);
    }
  }
  constexpr std::size_t kListed = 20;
  std::string remedy =
      "its materials are " + joinNames(std::span(names).first(std::min(names.size(), kListed)));
  if (names.size() > kListed) {
    remedy += fmt::format(" ({} more are not listed)", names.size() - kListed);
  }
  if (const auto nearest = nearestName(name, names)) {
    remedy = fmt::format("did you mean '{}'? {}", *nearest, remedy);
  }
  return source.refuse("", fmt::format("it has no material '{}' to mirror", cleanName(name)), remedy);
}

}  // namespace

Expected<void> chooseMirrors(const GltfSource& source, const std::string& mirror_material, Scene& scene) {
  if (!mirror_material.empty()) {
    bool found = false;
    for (Material& material : scene.materials) {
      material.mirror = material.name == mirror_material;
      found = found || material.mirror;
    }
    return found ? Expected<void>{} : Expected<void>(unknownMaterial(source, mirror_material, scene));
  }
  const std::vector<bool> used = usedMaterials(scene);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] && scene.materials[i].mirror) {
      return {};
    }
  }
  for (Material& material : scene.materials) {
    material.mirror = true;
  }
  scene.notes.emplace_back(
      "Nothing in the scene is a mirror, so everything is one; --mirror MATERIAL names a single one.");
  return {};
}

}  // namespace ssrkit
