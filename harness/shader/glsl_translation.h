// SPIR-V to OpenGL's GLSL, for drivers that take no SPIR-V.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/error.h"

namespace ssrkit {

enum class GlslVersion {
  k330,  // says nothing of bindings: the program's user sets them by name after linking
  k450,
};

struct GlslConstant {  // the value of a specialisation constant
  std::uint32_t id = 0;
  std::uint32_t bits = 0;  // of an int, uint, float or bool (0/1)
};

// The text of a module made for ShaderTarget::kOpenGl. Specialisation constants become constants: those given
// have these values, the others their defaults, and ids that the module lacks are ignored. Samplers and
// blocks are named after their bindings and variables between stages after their locations, so stages that
// were translated apart fit together. Fails (kInput) on a module made for Vulkan, and on what the language
// cannot say, with SPIRV-Cross' reason.
[[nodiscard]] Expected<std::string> translateToGlsl(std::span<const std::uint32_t> spirv, GlslVersion version,
                                                    std::span<const GlslConstant> constants);

// The names in the text.
[[nodiscard]] std::string glslSamplerName(std::uint32_t binding);
[[nodiscard]] std::string glslBlockName(std::uint32_t binding);

}  // namespace ssrkit
