#include "device/gl/gl_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "device/format.h"
#include "device/gl/egl_context.h"
#include "device/gl/gl_buffer.h"
#include "device/gl/gl_image.h"
#include "device/gl/gl_pass.h"
#include "device/gl/gl_program.h"
#include "device/gl/gl_samplers.h"
#include "device/gl/gl_session.h"
#include "device/gl/gl_timestamps.h"
#include "device/gl/osmesa_context.h"
#include "device/identity.h"
#include "device/pass_rules.h"

namespace ssrkit {
namespace {

// "4.5 (Core Profile) Mesa 22.3.6" is Mesa 22.3.6; another vendor's text is kept whole.
std::string driverVersion(const std::string& gl_version) {
  const std::size_t mesa = gl_version.find("Mesa");
  return mesa == std::string::npos ? gl_version : gl_version.substr(mesa);
}

DeviceIdentity identify(const GlSession& session, std::string_view id) {
  CpuIdentity cpu = cpuIdentity();
  return {.id = std::string(id),
          .api = fmt::format("OpenGL {}.{} core", session.integer(GL_MAJOR_VERSION),
                             session.integer(GL_MINOR_VERSION)),
          .driver = session.text(GL_RENDERER),
          .version = driverVersion(session.text(GL_VERSION)),
          .cpu = std::move(cpu.model),
          .cpu_features = std::move(cpu.features)};
}

class GlDevice final : public Device {
 public:
  GlDevice(std::shared_ptr<GlSession> session, std::string_view id)
      : session_(std::move(session)),
        identity_(identify(*session_, id)),
        samplers_(session_),
        timestamps_(session_) {}

  [[nodiscard]] const DeviceIdentity& identity() const override { return identity_; }
  [[nodiscard]] std::string shaderInput() const override { return infoOf(session_->shaderInput()).name; }

  [[nodiscard]] Expected<std::unique_ptr<DeviceImage>> createImage(const ImageDesc& desc) override {
    return GlImage::create(session_, desc);
  }

  [[nodiscard]] Expected<std::unique_ptr<DeviceBuffer>> createVertexBuffer(
      std::span<const std::byte> bytes) override {
    SSRKIT_CHECK(!bytes.empty());
    GlObject buffer = createBuffer(session_);
    session_->gl().NamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
    const std::string attempted = fmt::format("create a vertex buffer of {} bytes", bytes.size());
    if (const auto created = session_->failOnMessages(attempted, "choose a smaller scene"); !created) {
      return tl::unexpected(created.error());
    }
    return std::make_unique<GlVertexBuffer>(std::move(buffer), bytes.size());
  }

  [[nodiscard]] Expected<std::unique_ptr<DeviceProgram>> createProgram(const ProgramDesc& desc) override {
    return GlProgram::create(session_, desc);
  }

  [[nodiscard]] Expected<void> upload(DeviceImage& image, int mip,
                                      std::span<const std::byte> bytes) override {
    glImage(image).upload(mip, bytes);
    return {};
  }

  [[nodiscard]] Expected<std::vector<std::byte>> read(const DeviceImage& image, int mip) override {
    return glImage(image).read(mip);
  }

  [[nodiscard]] Expected<void> copy(const DeviceImage& from, int mip, Size size, DeviceImage& to, int x,
                                    int y) override {
    checkCopy(from.desc(), mip, size, to.desc(), x, y);
    const GladGLContext& gl = session_->gl();
    gl.CopyImageSubData(glImage(from).texture(), GL_TEXTURE_2D, mip, 0, 0, 0, glImage(to).texture(),
                        GL_TEXTURE_2D, 0, x, y, 0, size.width, size.height, 1);
    gl.Finish();
    return {};
  }

  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    return drawGlPass(session_, samplers_, timestamps_, pass);
  }

  [[nodiscard]] std::vector<std::string> drainMessages() override { return session_->drainMessages(); }

 private:
  std::shared_ptr<GlSession> session_;
  DeviceIdentity identity_;
  GlSamplers samplers_;
  GlTimestamps timestamps_;
};

Expected<std::unique_ptr<GlContext>> createContext(const GlDeviceChoice& choice) {
  const GlVersion version = infoOf(choice.shader_input).version;
  switch (choice.platform) {
    case GlPlatform::kOsmesa:
      return createOsmesaContext(version);
    case GlPlatform::kEglSurfaceless:
      return createEglContext(EglDisplayKind::kSurfaceless, version);
    case GlPlatform::kEglGpu:
      return createEglContext(EglDisplayKind::kGpu, version);
  }
  SSRKIT_CHECK(false);
}

bool isWanted(std::string_view renderer, std::string_view part) {
  constexpr std::array<std::string_view, 4> kSoftware{"llvmpipe", "softpipe", "swrast", "Software"};
  const auto names = [renderer](std::string_view name) {
    return renderer.find(name) != std::string_view::npos;
  };
  return part.empty() ? std::ranges::none_of(kSoftware, names) : names(part);
}

}  // namespace

Expected<std::unique_ptr<Device>> createGlDevice(const GlDeviceChoice& choice) {
  Expected<std::unique_ptr<GlContext>> context = createContext(choice);
  if (!context) {
    return tl::unexpected(context.error());
  }
  Expected<std::shared_ptr<GlSession>> session = GlSession::create(std::move(*context), choice.shader_input);
  if (!session) {
    return tl::unexpected(session.error());
  }
  const std::string renderer = (*session)->text(GL_RENDERER);
  if (!isWanted(renderer, choice.renderer_part)) {
    return setupError(
        fmt::format("open the device '{}'", choice.id),
        fmt::format("the driver that answers is '{}' and not {}", renderer,
                    choice.renderer_part.empty() ? "a GPU's" : "'" + choice.renderer_part + "'"),
        {}, "install Debian's packages libgl1-mesa-dri and mesa-vulkan-drivers");
  }
  return std::make_unique<GlDevice>(std::move(*session), choice.id);
}

}  // namespace ssrkit
