#include "device/gl/egl_library.h"

#include <dlfcn.h>

#include "device/gl/find_function.h"

namespace ssrkit {
namespace {

constexpr const char* kEglFile = "libEGL.so.1";
constexpr const char* kAttemptedEgl = "open EGL";

}  // namespace

Expected<EglLibrary> loadEgl() {
  void* const library = dlopen(kEglFile, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = dlerror();
    return setupError(kAttemptedEgl, reason != nullptr ? reason : "it cannot be loaded", kEglFile,
                      kInstallEgl);
  }
  EglLibrary egl;
  if (!findFunction(library, "eglInitialize", egl.initialize) ||
      !findFunction(library, "eglBindAPI", egl.bind_api) ||
      !findFunction(library, "eglCreateContext", egl.create_context) ||
      !findFunction(library, "eglDestroyContext", egl.destroy_context) ||
      !findFunction(library, "eglMakeCurrent", egl.make_current) ||
      !findFunction(library, "eglGetCurrentContext", egl.current_context) ||
      !findFunction(library, "eglGetError", egl.last_error) ||
      !findFunction(library, "eglGetPlatformDisplay", egl.platform_display) ||
      !findFunction(library, "eglGetProcAddress", egl.procedure)) {
    return setupError(kAttemptedEgl, "the library is older than EGL 1.5", kEglFile, kInstallEgl);
  }
  egl.query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.procedure("eglQueryDevicesEXT"));
  egl.query_device_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.procedure("eglQueryDeviceStringEXT"));
  return egl;
}

}  // namespace ssrkit
