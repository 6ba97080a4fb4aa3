// The kit's shaders with a mutant's change, in a folder of their own, and which entry files a change
// concerns.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "base/error.h"
#include "command/kit_paths.h"
#include "mutation/mutant.h"

namespace ssrkit {

// Entry files ("trace_hiz.frag") by the file that they are made of ("shaders/include/ssr_ray.glsl"),
// themselves among them.
using ShaderUses = std::map<std::filesystem::path, std::set<std::string>>;

// Compiles every entry file of the kit.
[[nodiscard]] Expected<ShaderUses> shaderUses(const std::filesystem::path& shader_root);

// Copies the shaders to folder/shaders, makes the change there, and compiles the entry files that it
// concerns: an edit that fits nowhere, or does not compile, is an Error and no mutant.
[[nodiscard]] Expected<std::filesystem::path> makeMutantShaders(const Mutant& mutant, const KitPaths& paths,
                                                                const ShaderUses& uses,
                                                                const std::filesystem::path& folder);

}  // namespace ssrkit
