#include "shader/spirv_cache.h"

#include <fmt/format.h>

#include "base/hash128.h"
#include "shader/front_end.h"
#include "shader/module_bytes.h"
#include "shader/spirv_tools.h"

namespace ssrkit {

namespace {

// Raise it when the same recipe gives another module or the bytes of an entry mean something else.
constexpr int kFormatVersion = 2;

}  // namespace

SpirvCache SpirvCache::ofUser() {
  return SpirvCache(EntryCache::ofUser("spirv", kFormatVersion));
}

std::optional<ShaderModule> SpirvCache::find(const std::string& recipe) const {
  const std::optional<std::string> payload = entries_.find(recipe);
  return payload ? moduleFromBytes(*payload) : std::nullopt;
}

void SpirvCache::store(const std::string& recipe, const ShaderModule& module) const {
  entries_.store(recipe, toBytes(module));
}

std::string compileRecipe(const SourceTree& tree, const std::string& preamble, ShaderStage stage,
                          ShaderTarget target, ModuleForm form) {
  std::string recipe =
      fmt::format("{}, {}\ntarget {} stage {} form {}\n{}", frontEndVersion(), spirvToolsVersion(),
                  static_cast<int>(target), static_cast<int>(stage), static_cast<int>(form), preamble);
  for (const SourceFile& file : tree.files) {
    recipe += fmt::format("file {} {}\n", file.text.size(), hashName(file.text));
    for (const IncludeEdge& edge : file.includes) {
      recipe += edge.target ? fmt::format("include {}\n", *edge.target) : "include nothing\n";
    }
  }
  return recipe;
}

}  // namespace ssrkit
