// Compiled modules on disk (base/entry_cache.h).
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/entry_cache.h"
#include "shader/compiler.h"
#include "shader/source_tree.h"

namespace ssrkit {

class SpirvCache {
 public:
  // $XDG_CACHE_HOME/ssrkit/spirv, or ~/.cache/ssrkit/spirv; no folder at all when neither is set.
  [[nodiscard]] static SpirvCache ofUser();

  explicit SpirvCache(EntryCache entries) : entries_(std::move(entries)) {}

  [[nodiscard]] std::optional<ShaderModule> find(const std::string& recipe) const;

  void store(const std::string& recipe, const ShaderModule& module) const;

 private:
  EntryCache entries_;
};

// Versions, target, stage, options, preamble, and the hash of every source and where each #include leads.
[[nodiscard]] std::string compileRecipe(const SourceTree& tree, const std::string& preamble,
                                        ShaderStage stage, ShaderTarget target, ModuleForm form);

}  // namespace ssrkit
