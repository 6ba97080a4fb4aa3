#include "scene/find_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "base/text.h"
#include "scene/clean_name.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 12> kOrder{"m1",     "m2",     "m3",    "m4",       "clutter", "thin",
                                             "facing", "curved", "gloss", "corridor", "outdoor", "moving"};

fs::path fileOf(const std::string& name, const fs::path& scenes_root) {
  return scenes_root / name / (name + ".gltf");
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

std::vector<std::string> builtInScenes(const fs::path& scenes_root) {
  std::vector<std::string> names;
  std::copy_if(kOrder.begin(), kOrder.end(), std::back_inserter(names),
               [&](const std::string& name) { return isFile(fileOf(name, scenes_root)); });
  return names;
}

Expected<fs::path> findScene(std::string_view name_or_path, const fs::path& scenes_root) {
  const std::vector<std::string> names = builtInScenes(scenes_root);
  const std::string wanted(name_or_path);
  if (std::find(names.begin(), names.end(), wanted) != names.end()) {
    return fileOf(wanted, scenes_root);
  }
  const fs::path path(wanted);
  if (!wanted.empty() && isFile(path)) {
    return path;
  }
  const std::string attempted = fmt::format("find the scene '{}'", cleanName(wanted));
  std::error_code ignored;
  if (!wanted.empty() && fs::is_directory(path, ignored)) {
    return inputError(attempted, "it is a folder", "", "name the .gltf or .glb file in it");
  }
  if (path.has_extension() || path.has_parent_path()) {
    return inputError(attempted, "there is no such file", "", "check the spelling of the path");
  }
  const auto nearest = nearestName(wanted, names);
  const std::string list =
      "the built-in scenes are " + joinNames(names) + ", and any .gltf or .glb file can be named";
  return inputError(attempted, "there is no built-in scene or file of that name", "",
                    nearest ? fmt::format("did you mean '{}'? {}", *nearest, list) : list);
}

}  // namespace ssrkit
