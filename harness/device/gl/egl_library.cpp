#include "device/gl/egl_library.h"

#include <dlfcn.h>

namespace ssrkit {
namespace {

constexpr const char* kLibrary = "libEGL.so.1";
constexpr const char* kAttempted = "open EGL";
constexpr const char* kInstall = "install Debian's packages libegl1 and libgl1-mesa-dri";

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

}  // namespace

Expected<EglLibrary> loadEgl() {
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = dlerror();
    return setupError(kAttempted, reason != nullptr ? reason : "it cannot be loaded", kLibrary, kInstall);
  }
  EglLibrary egl;
  if (!find(library, "eglInitialize", egl.initialize) || !find(library, "eglBindAPI", egl.bind_api) ||
      !find(library, "eglCreateContext", egl.create_context) ||
      !find(library, "eglDestroyContext", egl.destroy_context) ||
      !find(library, "eglMakeCurrent", egl.make_current) ||
      !find(library, "eglGetCurrentContext", egl.current_context) ||
      !find(library, "eglGetError", egl.last_error) ||
      !find(library, "eglGetPlatformDisplay", egl.platform_display) ||
      !find(library, "eglGetProcAddress", egl.procedure)) {
    return setupError(kAttempted, "the library is older than EGL 1.5", kLibrary, kInstall);
  }
  egl.query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.procedure("eglQueryDevicesEXT"));
  egl.query_device_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.procedure("eglQueryDeviceStringEXT"));
  return egl;
}

}  // namespace ssrkit
