// What `ssrkit compile --out` writes: a shader as the devices' drivers are given it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/compile_report.h"

namespace ssrkit {

// Of each module its words (NAME.opengl.spv, NAME.vulkan.spv; little-endian) and its disassembly (.spvasm),
// and the GLSL that gl-glsl and gl-softpipe are given in OpenGL's place, with the defaults of specialisation
// constants. All modules must have compiled. Every file is made before the first is written.
[[nodiscard]] Expected<std::vector<CompiledFile>> writeCompiled(const std::filesystem::path& folder,
                                                                const std::string& name,
                                                                std::span<const CompileResult> results);

}  // namespace ssrkit
