#include "command/mutant_shaders.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "mutation/text_edit.h"
#include "shader/compiler.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

Expected<ShaderModule> compileEntry(const fs::path& root, const std::string& entry) {
  const auto stage = stageOfFile(entry);
  return stage ? compileShader({.root = root, .entry = entry, .stage = *stage, .defines = {}},
                               ShaderTarget::kOpenGl)
               : tl::make_unexpected(stage.error());
}

Expected<std::string> changedText(const Mutant& mutant, const KitPaths& paths) {
  if (!mutant.shader.empty()) {
    return readFile(mutant.shader);
  }
  const auto original = readFile(paths.root / mutant.edit.file);
  return original ? applyEdit(*original, mutant.edit, mutant.where) : original;
}

}  // namespace

Expected<ShaderUses> shaderUses(const fs::path& shader_root) {
  ShaderUses uses;
  std::error_code ignored;
  const fs::path root = fs::canonical(shader_root, ignored);
  for (const fs::directory_entry& entry : fs::directory_iterator(root, ignored)) {
    if (entry.path().extension() != ".frag" && entry.path().extension() != ".vert") {
      continue;
    }
    const std::string name = entry.path().filename().string();
    const auto module = compileEntry(root, name);
    if (!module) {
      return tl::make_unexpected(module.error());
    }
    for (const fs::path& file : module->dependencies) {
      uses["shaders" / file.lexically_relative(root)].insert(name);
    }
  }
  return uses;
}

Expected<fs::path> makeMutantShaders(const Mutant& mutant, const KitPaths& paths, const ShaderUses& uses,
                                     const fs::path& folder) {
  const auto text = changedText(mutant, paths);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  const std::string attempted = fmt::format("make the shaders of '{}'", mutant.name);
  const auto used = uses.find(mutant.edit.file);
  if (used == uses.end()) {
    return inputError(attempted, fmt::format("no pass is made of '{}'", mutant.edit.file.string()),
                      mutant.where, "name a file under shaders/ that a pass includes");
  }
  std::error_code failed;
  fs::copy(fs::canonical(paths.shaders, failed), folder / "shaders", fs::copy_options::recursive, failed);
  if (failed) {
    return setupError(attempted, failed.message(), (folder / "shaders").string());
  }
  if (const auto written = writeFileAtomically(folder / mutant.edit.file, *text); !written) {
    return tl::make_unexpected(written.error());
  }
  for (const std::string& entry : used->second) {
    if (const auto module = compileEntry(folder / "shaders", entry); !module) {
      return tl::make_unexpected(module.error());
    }
  }
  return folder / "shaders";
}

}  // namespace ssrkit
