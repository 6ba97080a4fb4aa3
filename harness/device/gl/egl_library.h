// libEGL's entry points, found when the first context on EGL is made.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "base/error.h"

namespace ssrkit {

inline constexpr const char* kInstallEgl = "install Debian's packages libegl1 and libgl1-mesa-dri";

struct EglLibrary {
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglCreateContext) create_context = nullptr;
  decltype(&eglDestroyContext) destroy_context = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglGetCurrentContext) current_context = nullptr;
  decltype(&eglGetError) last_error = nullptr;
  decltype(&eglGetPlatformDisplay) platform_display = nullptr;
  decltype(&eglGetProcAddress) procedure = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;  // these two are extensions: may be null
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;
};

// Never closed, as drivers leave threads and exit handlers behind. Fails (kSetup) where it is not installed
// or is older than EGL 1.5.
[[nodiscard]] Expected<EglLibrary> loadEgl();

}  // namespace ssrkit
