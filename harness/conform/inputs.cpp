#include "conform/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/atomic_file.h"
#include "base/hash128.h"
#include "scene/scene_files.h"

namespace ssrkit {

namespace fs = std::filesystem;

Expected<InputHasher> InputHasher::create(const fs::path& program, const fs::path& shader_root) {
  InputHasher hasher;
  const auto program_hash = hasher.ofFile(program);
  const auto shaders_hash = program_hash ? hasher.ofFolder(shader_root) : program_hash;
  if (!shaders_hash) {
    return tl::make_unexpected(shaders_hash.error());
  }
  hasher.kit_ = *program_hash + " " + *shaders_hash;
  return hasher;
}

Expected<std::string> InputHasher::inputs(const CellInputs& cell) {
  const auto test = ofFile(cell.test_file);
  const auto goldens = test ? ofGoldens(cell.goldens) : test;
  if (!goldens) {
    return tl::make_unexpected(goldens.error());
  }
  std::string recipe =
      fmt::format("{}\n{}\n{}\n{}\n{}\n", cell.id, kit_, *test, ofScene(cell.scene_file), *goldens);
  for (const DeviceIdentity& device : cell.devices) {
    recipe += fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", device.id, device.api, device.driver, device.version,
                          device.cpu, fmt::join(device.cpu_features, " "));
  }
  return hashName(recipe);
}

Expected<std::string> InputHasher::ofFile(const fs::path& file) {
  if (const auto known = known_.find(file); known != known_.end()) {
    return known->second;
  }
  const auto content = readFile(file);
  if (!content) {
    return tl::make_unexpected(content.error());
  }
  return known_[file] = hashName(*content);
}

// What is not there, or cannot be read, is the cell's to tell.
std::string InputHasher::ofScene(const fs::path& scene_file) {
  if (const auto known = scenes_.find(scene_file); known != scenes_.end()) {
    return known->second;
  }
  const fs::path folder = fs::absolute(scene_file).parent_path();
  std::string recipe;
  for (const fs::path& file : sceneFiles(fs::absolute(scene_file))) {
    recipe +=
        fmt::format("{}\n{}\n", file.lexically_relative(folder).string(), ofFile(file).value_or("none"));
  }
  return scenes_[scene_file] = hashName(recipe);
}

Expected<std::string> InputHasher::ofGoldens(const fs::path& folder) {
  std::error_code ignored;
  return folder.empty() || !fs::exists(folder, ignored) ? "" : ofFolder(folder);
}

Expected<std::string> InputHasher::ofFolder(const fs::path& folder) {
  if (const auto known = known_.find(folder); known != known_.end()) {
    return known->second;
  }
  std::vector<fs::path> files;
  std::error_code failure;
  for (auto entry = fs::recursive_directory_iterator(folder, failure); !failure && entry != fs::end(entry);
       entry.increment(failure)) {
    if (entry->is_regular_file(failure)) {
      files.push_back(entry->path());
    }
  }
  if (failure) {
    return setupError("hash the files of a folder", failure.message(), folder.string());
  }
  std::ranges::sort(files);
  const auto hash = ofFiles(files, folder);
  return hash ? known_[folder] = *hash : hash;
}

Expected<std::string> InputHasher::ofFiles(const std::vector<fs::path>& files, const fs::path& folder) {
  std::string recipe;
  for (const fs::path& file : files) {
    const auto hash = ofFile(file);
    if (!hash) {
      return tl::make_unexpected(hash.error());
    }
    recipe += file.lexically_relative(folder).string() + "\n" + *hash + "\n";
  }
  return hashName(recipe);
}

}  // namespace ssrkit
