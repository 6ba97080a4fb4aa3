// The OpenGL device: direct state access, framebuffer objects, and programs from SPIR-V (GL_ARB_gl_spirv) or
// from GLSL that SPIR-V was translated to.
#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "device/gl/gl_shader_input.h"

namespace ssrkit {

enum class GlPlatform { kOsmesa, kEglSurfaceless, kEglGpu };

struct GlDeviceChoice {
  std::string id;  // becomes identity().id
  GlPlatform platform = GlPlatform::kOsmesa;
  GlShaderInput shader_input = GlShaderInput::kSpirv;
  // What GL_RENDERER must contain: where a driver does not start, Mesa may hand out another without a word.
  // Empty: any that is no software rasteriser.
  std::string renderer_part;
};

// The environment chooses among Mesa's drivers (the registry's rows say how), once for the process. Fails
// (kSetup) where the driver is not there or is another one.
[[nodiscard]] Expected<std::unique_ptr<Device>> createGlDevice(const GlDeviceChoice& choice);

}  // namespace ssrkit
