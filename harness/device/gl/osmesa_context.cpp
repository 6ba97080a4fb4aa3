#include "device/gl/osmesa_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/check.h"
#include "device/gl/find_function.h"

#ifdef __SANITIZE_ADDRESS__
// Kept for ever: by OSMesa a buffer of every context, by lavapipe and the validation layer things of each
// instance.
extern "C" const char*
__lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier): the sanitizer's name
  return "leak:libOSMesa.so\nleak:libvulkan_lvp.so\nleak:libVkLayer_khronos_validation.so\n";
}
#endif

namespace ssrkit {
namespace {

constexpr const char* kOsmesaFile = "libOSMesa.so.8";
constexpr const char* kAttemptedOsmesa = "open the OSMesa software renderer";
constexpr const char* kInstallOsmesa = "install Debian's package libosmesa6";

struct OsmesaLibrary {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetCurrentContext) current_context = nullptr;
  decltype(&OSMesaGetProcAddress) procedure = nullptr;
};

// Never closed: Mesa and LLVM leave threads and exit handlers behind that need their code.
Expected<OsmesaLibrary> loadOsmesa() {
  void* const library = dlopen(kOsmesaFile, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = dlerror();
    return setupError(kAttemptedOsmesa, reason != nullptr ? reason : "it cannot be loaded", kOsmesaFile,
                      kInstallOsmesa);
  }
  OsmesaLibrary osmesa;
  if (!findFunction(library, "OSMesaCreateContextAttribs", osmesa.create_context) ||
      !findFunction(library, "OSMesaDestroyContext", osmesa.destroy_context) ||
      !findFunction(library, "OSMesaMakeCurrent", osmesa.make_current) ||
      !findFunction(library, "OSMesaGetCurrentContext", osmesa.current_context) ||
      !findFunction(library, "OSMesaGetProcAddress", osmesa.procedure)) {
    return setupError(kAttemptedOsmesa, "the library is too old for OpenGL 4.5 core", kOsmesaFile,
                      kInstallOsmesa);
  }
  return osmesa;
}

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext(const OsmesaLibrary& library, OSMesaContext context) : library_(library), context_(context) {}
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  ~OsmesaContext() override {
    if (library_.current_context() == context_) {
      library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }
    library_.destroy_context(context_);
  }

  void makeCurrent() override {
    if (library_.current_context() != context_) {
      SSRKIT_CHECK(library_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE);
    }
  }

  [[nodiscard]] Procedure procedure(const char* name) const override { return library_.procedure(name); }

 private:
  OsmesaLibrary library_;
  OSMesaContext context_;
  std::array<std::uint8_t, 4> buffer_{};
};

}  // namespace

Expected<std::unique_ptr<GlContext>> createOsmesaContext(GlVersion version) {
  // OSMesa 22.3 follows a null pointer when this variable names a driver that it does not have.
  const char* const driver = std::getenv("GALLIUM_DRIVER");
  if (driver != nullptr && std::string_view(driver) != "llvmpipe" && std::string_view(driver) != "softpipe") {
    return setupError(kAttemptedOsmesa,
                      std::string("GALLIUM_DRIVER is '") + driver + "', which OSMesa does not have", {},
                      "unset it or set it to llvmpipe");
  }
  const Expected<OsmesaLibrary> library = loadOsmesa();
  if (!library) {
    return tl::unexpected(library.error());
  }
  const std::array<int, 11> attributes{OSMESA_FORMAT,
                                       OSMESA_RGBA,
                                       OSMESA_PROFILE,
                                       OSMESA_CORE_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       version.major,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       version.minor,
                                       OSMESA_DEPTH_BITS,
                                       0,
                                       0};
  OSMesaContext context = library->create_context(attributes.data(), nullptr);
  if (context == nullptr) {
    return setupError(kAttemptedOsmesa,
                      fmt::format("it refused an OpenGL {}.{} core context", version.major, version.minor),
                      kOsmesaFile, "set GALLIUM_DRIVER=llvmpipe, or install Mesa 22.3 or newer");
  }
  auto result = std::make_unique<OsmesaContext>(*library, context);
  result->makeCurrent();
  return result;
}

}  // namespace ssrkit
