#include "shader/spirv_cache.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <utility>

#include "base/atomic_file.h"
#include "shader/front_end.h"
#include "shader/hash128.h"
#include "shader/module_bytes.h"
#include "shader/spirv_tools.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

// Raise it when the same recipe gives another module or the bytes of an entry mean something else.
constexpr int kFormatVersion = 2;
constexpr std::size_t kEntryLimitBytes = std::size_t{64} << 20;

std::string firstLine(const std::string& recipe, const std::string& payload) {
  return fmt::format("ssrkit-spirv {} recipe {} payload {} {}\n", kFormatVersion, recipe.size(),
                     payload.size(), hashName(payload));
}

fs::path absoluteFolder(const char* variable) {
  const char* const value = std::getenv(variable);
  const fs::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : fs::path();
}

}  // namespace

SpirvCache SpirvCache::ofUser() {
  fs::path base = absoluteFolder("XDG_CACHE_HOME");
  if (base.empty()) {
    const fs::path home = absoluteFolder("HOME");
    base = home.empty() ? fs::path() : home / ".cache";
  }
  return SpirvCache(base.empty() ? fs::path() : base / "ssrkit" / "spirv");
}

fs::path SpirvCache::pathOf(const std::string& recipe) const {
  return folder_ / (hashName(recipe) + ".spirv-entry");
}

std::optional<ShaderModule> SpirvCache::find(const std::string& recipe) const {
  if (folder_.empty()) {
    return std::nullopt;
  }
  const Expected<std::string> entry = readFile(pathOf(recipe), kEntryLimitBytes);
  if (!entry) {
    return std::nullopt;
  }
  const std::size_t line_end = entry->find('\n');
  if (line_end == std::string::npos || entry->compare(line_end + 1, recipe.size(), recipe) != 0) {
    return std::nullopt;
  }
  const std::string payload = entry->substr(line_end + 1 + recipe.size());
  if (entry->compare(0, line_end + 1, firstLine(recipe, payload)) != 0) {
    return std::nullopt;
  }
  return moduleFromBytes(payload);
}

void SpirvCache::store(const std::string& recipe, const ShaderModule& module) const {
  if (folder_.empty()) {
    return;
  }
  const std::string payload = toBytes(module);
  static_cast<void>(writeFileAtomically(pathOf(recipe), firstLine(recipe, payload) + recipe + payload));
}

std::string compileRecipe(const SourceTree& tree, const std::string& preamble, ShaderStage stage,
                          ShaderTarget target, bool optimise) {
  std::string recipe =
      fmt::format("{}, {}\ntarget {} stage {} optimise {}\n{}", frontEndVersion(), spirvToolsVersion(),
                  static_cast<int>(target), static_cast<int>(stage), optimise, preamble);
  for (const SourceFile& file : tree.files) {
    recipe += fmt::format("file {} {}\n", file.text.size(), hashName(file.text));
    for (const IncludeEdge& edge : file.includes) {
      recipe += edge.target ? fmt::format("include {}\n", *edge.target) : "include nothing\n";
    }
  }
  return recipe;
}

}  // namespace ssrkit
