// Compiled modules on disk, named by what they were made from. Several runs may share the folder: an entry
// appears whole or not at all, and a damaged one counts as absent.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shader/compiler.h"
#include "shader/source_tree.h"

namespace ssrkit {

class SpirvCache {
 public:
  // $XDG_CACHE_HOME/ssrkit/spirv, or ~/.cache/ssrkit/spirv; no folder at all when neither is set.
  [[nodiscard]] static SpirvCache ofUser();

  explicit SpirvCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // `recipe` is everything that decides the module; the entry holds it and is refused when it differs.
  [[nodiscard]] std::optional<ShaderModule> find(const std::string& recipe) const;

  // Does nothing when the folder cannot be written: the next run compiles again.
  void store(const std::string& recipe, const ShaderModule& module) const;

  [[nodiscard]] std::filesystem::path pathOf(const std::string& recipe) const;

 private:
  std::filesystem::path folder_;
};

// Versions, target, stage, options, preamble, and the hash of every source and where each #include leads.
[[nodiscard]] std::string compileRecipe(const SourceTree& tree, const std::string& preamble,
                                        ShaderStage stage, ShaderTarget target, bool optimise);

}  // namespace ssrkit
