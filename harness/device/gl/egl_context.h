#pragma once

#include <memory>

#include "base/error.h"
#include "device/gl/gl_context.h"

namespace ssrkit {

enum class EglDisplayKind {
  kSurfaceless,  // Mesa's choice of a driver, which LIBGL_ALWAYS_SOFTWARE and GALLIUM_DRIVER steer
  kGpu,          // the first device that is no software rasteriser
};

// A core context on EGL without any surface. libEGL is loaded here and not before. Fails (kSetup) without the
// library, without a display of the kind, or where the driver refuses the version.
[[nodiscard]] Expected<std::unique_ptr<GlContext>> createEglContext(EglDisplayKind kind,
                                                                    GlVersion version = {});

}  // namespace ssrkit
