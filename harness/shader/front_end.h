// glslang, in process: one GLSL text to SPIR-V for either API.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "shader/compiler.h"
#include "shader/source_tree.h"

namespace ssrkit {

struct FrontEndOptions {
  ShaderTarget target = ShaderTarget::kOpenGl;
  ShaderStage stage = ShaderStage::kFragment;
  std::string preamble;       // see makePreamble
  bool line_numbers = false;  // OpLine in the module; Mesa's GL refuses such modules, so only for looking at
};

// By its name: it ends in .hlsl. Anything else is GLSL.
[[nodiscard]] bool isHlsl(const std::filesystem::path& file);

// What stands before line 1 of every shader, without moving the author's line numbers: #include is switched
// on, SSR_VERTEX_INDEX is the target's vertex index, and the defines follow. Fails on a define that is no
// name.
[[nodiscard]] Expected<std::string> makePreamble(const ShaderSource& source, ShaderTarget target,
                                                 const std::string& attempted);

// Builds glslang's built-in symbols for the target (about 70 ms), once in a process: children inherit them.
void prepareFrontEnd(ShaderTarget target);

// Not for several threads at once. Names of includes are resolved by the tree alone.
[[nodiscard]] Expected<std::vector<std::uint32_t>> translateToSpirv(const SourceTree& tree,
                                                                    const FrontEndOptions& options,
                                                                    const std::string& attempted);

// "glslang 12.0.0"
[[nodiscard]] std::string frontEndVersion();

}  // namespace ssrkit
