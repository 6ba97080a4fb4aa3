#include "device/gl/egl_context.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "device/gl/egl_library.h"

namespace ssrkit {
namespace {

constexpr const char* kAttemptedEglContext = "open OpenGL on EGL";
constexpr const char* kInstallGpu =
    "install the GPU's driver (Debian's libgl1-mesa-dri has those of AMD and Intel)";

// A display of Mesa is one for the whole process: it is not terminated, because another context may use it.
class EglContext final : public GlContext {
 public:
  EglContext(const EglLibrary& egl, EGLDisplay display, EGLContext context)
      : egl_(egl), display_(display), context_(context) {}
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  ~EglContext() override {
    if (egl_.current_context() == context_) {
      egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl_.destroy_context(display_, context_);
  }

  void makeCurrent() override {
    if (egl_.current_context() != context_) {
      SSRKIT_CHECK(egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE);
    }
  }

  [[nodiscard]] Procedure procedure(const char* name) const override { return egl_.procedure(name); }

 private:
  EglLibrary egl_;
  EGLDisplay display_;
  EGLContext context_;
};

bool isSoftware(const EglLibrary& egl, EGLDeviceEXT device) {
  const char* const extensions = egl.query_device_string(device, EGL_EXTENSIONS);
  return extensions != nullptr &&
         std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

Expected<EGLDisplay> gpuDisplay(const EglLibrary& egl) {
  constexpr EGLint kMostDevices = 16;
  std::array<EGLDeviceEXT, kMostDevices> devices{};
  EGLint count = 0;
  if (egl.query_devices == nullptr || egl.query_device_string == nullptr ||
      egl.query_devices(kMostDevices, devices.data(), &count) != EGL_TRUE) {
    return setupError(kAttemptedEglContext, "EGL cannot list its devices", {}, kInstallGpu);
  }
  for (EGLint i = 0; i < count; ++i) {
    EGLDeviceEXT const device = devices[static_cast<std::size_t>(i)];
    if (!isSoftware(egl, device)) {
      return egl.platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    }
  }
  return setupError(kAttemptedEglContext, fmt::format("none of EGL's {} devices is a GPU", count), {},
                    kInstallGpu);
}

Expected<EGLDisplay> openDisplay(const EglLibrary& egl, EglDisplayKind kind) {
  const Expected<EGLDisplay> display =
      kind == EglDisplayKind::kGpu
          ? gpuDisplay(egl)
          : egl.platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!display) {
    return display;
  }
  if (*display == EGL_NO_DISPLAY || egl.initialize(*display, nullptr, nullptr) != EGL_TRUE) {
    return setupError(kAttemptedEglContext,
                      fmt::format("the display cannot be opened (error 0x{:x})", egl.last_error()), {},
                      kind == EglDisplayKind::kGpu ? kInstallGpu : kInstallEgl);
  }
  return display;
}

}  // namespace

Expected<std::unique_ptr<GlContext>> createEglContext(EglDisplayKind kind, GlVersion version) {
  const Expected<EglLibrary> egl = loadEgl();
  if (!egl) {
    return tl::unexpected(egl.error());
  }
  const Expected<EGLDisplay> display = openDisplay(*egl, kind);
  if (!display) {
    return tl::unexpected(display.error());
  }
  const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         version.major,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         version.minor,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
  egl->bind_api(EGL_OPENGL_API);
  EGLContext const context =
      egl->create_context(*display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) {
    return setupError(kAttemptedEglContext,
                      fmt::format("the driver refused an OpenGL {}.{} core context (error 0x{:x})",
                                  version.major, version.minor, egl->last_error()),
                      {}, kInstallEgl);
  }
  auto result = std::make_unique<EglContext>(*egl, *display, context);
  result->makeCurrent();
  return result;
}

}  // namespace ssrkit
