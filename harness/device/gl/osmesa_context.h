#pragma once

#include <memory>

#include "base/error.h"
#include "device/gl/gl_context.h"

namespace ssrkit {

// A core context on OSMesa with a default buffer of one texel: everything is drawn to framebuffer objects.
// The library is loaded here and not before, so that a process that makes no device pays for no driver.
// GALLIUM_DRIVER chooses the driver, once for the process.
[[nodiscard]] Expected<std::unique_ptr<GlContext>> createOsmesaContext(GlVersion version = {});

}  // namespace ssrkit
