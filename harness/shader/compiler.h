// GLSL to SPIR-V, in process, for both APIs from one source.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "shader/interface.h"

namespace ssrkit {

enum class ShaderTarget {
  kOpenGl,  // GL_ARB_gl_spirv: OpenGL 4.5, SPIR-V 1.0; GL_SPIRV is defined
  kVulkan,  // Vulkan 1.1, SPIR-V 1.3; VULKAN is defined
};

enum class ShaderStage { kVertex, kFragment };  // by the file's extension: .vert, .frag; or named

// What is compiled. Includes are looked up beside the including file and then in `root`/include, never
// outside `root` (nor outside the entry file's own folder, for a file that somebody put in a pass's place).
struct ShaderSource {
  std::filesystem::path root;   // the shaders folder
  std::filesystem::path entry;  // relative to root, or absolute for a file of the user's own
  ShaderStage stage = ShaderStage::kFragment;
  std::vector<std::pair<std::string, std::string>> defines;
};

struct ShaderModule {
  std::vector<std::uint32_t> spirv;
  ShaderInterface interface;
  std::vector<std::filesystem::path> dependencies;  // entry first
  bool from_cache = false;
};

// What is done to a module after glslang. None of them may change what a right driver computes.
enum class ModuleForm : std::uint8_t {
  kPlain,
  kOptimised,         // spirv-opt -O
  kOptimisedSize,     // spirv-opt -Os
  kRobust,            // spirv-opt --graphics-robust-access: every index is clamped to its array
  kDeadCode,          // sums with a zero that the compiler does not know, and a branch that is never taken
  kCountedLoops,      // fragments whose loops run too often write something else
  kUniformsReversed,  // the uniform block's members in the opposite order
};

struct CompileOptions {
  ModuleForm form = ModuleForm::kPlain;
  bool use_cache = true;
};

// By the extension: .vert or .frag, or either before .glsl (a.frag.glsl). A bare .glsl is a fragment shader.
[[nodiscard]] Expected<ShaderStage> stageOfFile(const std::filesystem::path& path);

// Compiles, validates for the target's environment (spirv-val) and reflects. Errors name the author's file,
// line and column, the first error first, all of them in `reasons`. A loop that no path leaves is an error
// too.
[[nodiscard]] Expected<ShaderModule> compileShader(const ShaderSource& source, ShaderTarget target,
                                                   const CompileOptions& options = {});

}  // namespace ssrkit
