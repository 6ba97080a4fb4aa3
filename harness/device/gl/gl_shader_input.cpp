#include "device/gl/gl_shader_input.h"

#include "base/check.h"

namespace ssrkit {

GlShaderInputInfo infoOf(GlShaderInput input) {
  switch (input) {
    case GlShaderInput::kSpirv:
      return {"SPIR-V", {4, 5}};  // OSMesa refuses 4.6
    case GlShaderInput::kGlsl450:
      return {"GLSL 450", {4, 5}};
    case GlShaderInput::kGlsl330:
      return {"GLSL 330", {3, 3}};
  }
  SSRKIT_CHECK(false);
}

}  // namespace ssrkit
