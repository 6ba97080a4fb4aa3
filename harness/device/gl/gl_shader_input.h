// The ways in which a program's SPIR-V reaches an OpenGL driver.
#pragma once

#include "device/gl/gl_context.h"

namespace ssrkit {

enum class GlShaderInput {
  kSpirv,    // as it is, by GL_ARB_gl_spirv
  kGlsl450,  // translated; the driver compiles the text
  kGlsl330,  // translated, for drivers that have stopped at OpenGL 3.3
};

struct GlShaderInputInfo {
  const char* name;   // "GLSL 330", as `ssrkit devices` shows it
  GlVersion version;  // of the context
};
[[nodiscard]] GlShaderInputInfo infoOf(GlShaderInput input);

}  // namespace ssrkit
