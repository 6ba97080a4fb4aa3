// SPIRV-Tools: is the module legal for its API, and the optimiser.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "shader/compiler.h"

namespace ssrkit {

// `where` is the entry file, for the error.
[[nodiscard]] Expected<void> validateSpirv(const std::vector<std::uint32_t>& spirv, ShaderTarget target,
                                           const std::string& where, const std::string& attempted);

// The module in another form. Bindings and specialisation constants that nothing uses stay declared.
[[nodiscard]] Expected<std::vector<std::uint32_t>> rewriteSpirv(const std::vector<std::uint32_t>& spirv,
                                                                ModuleForm form, ShaderTarget target,
                                                                const std::string& where,
                                                                const std::string& attempted);

// The module as text that spirv-as reads back, ids by their names in the source. Fails on what is no module.
[[nodiscard]] Expected<std::string> disassembleSpirv(const std::vector<std::uint32_t>& spirv,
                                                     ShaderTarget target, const std::string& attempted);

// "SPIRV-Tools v2023.1"
[[nodiscard]] std::string spirvToolsVersion();

}  // namespace ssrkit
