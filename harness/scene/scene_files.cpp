#include "scene/scene_files.h"

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "scene/defaults.h"
#include "scene/gltf_container.h"
#include "scene/gltf_json.h"
#include "scene/gltf_uri.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

// Before the schema is checked: whatever has another form names nothing.
void addNamed(const GltfSource& source, const nlohmann::json& root, const char* list,
              std::set<fs::path>& files) {
  const auto found = root.is_object() ? root.find(list) : root.end();
  if (found == root.end() || !found->is_array()) {
    return;
  }
  for (const nlohmann::json& item : *found) {
    const auto uri = item.is_object() ? item.find("uri") : item.end();
    if (uri == item.end() || !uri->is_string() || isDataUri(uri->get_ref<const std::string&>())) {
      continue;
    }
    if (const auto file = gltfUriFile(source, uri->get_ref<const std::string&>(), list)) {
      files.insert(*file);
    }
  }
}

}  // namespace

std::vector<fs::path> sceneFiles(const fs::path& scene_file) {
  const GltfSource source{scene_file};
  const fs::path defaults_file = defaultsFileOf(scene_file);
  std::set<fs::path> files = {scene_file, defaults_file};
  if (const auto defaults = loadSceneDefaults(defaults_file);
      defaults && defaults->environment && !defaults->environment->file.empty()) {
    files.insert(defaults->environment->file);
  }
  const auto root = readGltfContainer(source).and_then(
      [&](const GltfContainer& container) { return parseGltfJson(source, container.json_text); });
  if (root) {
    addNamed(source, *root, "buffers", files);
    addNamed(source, *root, "images", files);
  }
  return {files.begin(), files.end()};
}

}  // namespace ssrkit
