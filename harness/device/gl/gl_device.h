// The OpenGL device: 4.5 core with SPIR-V programs (GL_ARB_gl_spirv), direct state access, framebuffer
// objects.
#pragma once

#include <memory>
#include <string_view>

#include "base/error.h"
#include "device/device.h"

namespace ssrkit {

// On OSMesa; the environment chooses the driver (GALLIUM_DRIVER). `id` goes into the identity.
[[nodiscard]] Expected<std::unique_ptr<Device>> createOsmesaDevice(std::string_view id);

}  // namespace ssrkit
