#include "device/gl/gl_session.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace ssrkit {
namespace {

constexpr const char* kAttemptedStart = "start OpenGL";

GLADapiproc findProcedure(void* context, const char* name) {
  return static_cast<const GlContext*>(context)->procedure(name);
}

struct Ability {
  const char* extension;
  int present;
};

// What the kit calls beyond OpenGL 3.3: part of 4.5, and extensions of a context that has stopped before it.
std::array<Ability, 8> abilitiesOf(const GladGLContext& gl) {
  return {{{"GL_ARB_buffer_storage", gl.ARB_buffer_storage},
           {"GL_ARB_clip_control", gl.ARB_clip_control},
           {"GL_ARB_copy_image", gl.ARB_copy_image},
           {"GL_ARB_direct_state_access", gl.ARB_direct_state_access},
           {"GL_ARB_texture_storage", gl.ARB_texture_storage},
           {"GL_ARB_texture_view", gl.ARB_texture_view},
           {"GL_ARB_vertex_attrib_binding", gl.ARB_vertex_attrib_binding},
           {"GL_KHR_debug", gl.KHR_debug}}};
}

}  // namespace

Expected<std::shared_ptr<GlSession>> GlSession::create(std::unique_ptr<GlContext> context,
                                                       GlShaderInput input) {
  std::shared_ptr<GlSession> session(new GlSession(std::move(context), input));
  session->context_->makeCurrent();
  const int version = gladLoadGLContextUserPtr(&session->gl_, findProcedure, session->context_.get());
  if (const auto able = session->checkAbilities({GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)});
      !able) {
    return tl::unexpected(able.error());
  }
  session->setState();
  return session;
}

Expected<void> GlSession::checkAbilities(GlVersion offered) const {
  const GlVersion needed = infoOf(shader_input_).version;
  if (std::pair(offered.major, offered.minor) < std::pair(needed.major, needed.minor)) {
    return setupError(kAttemptedStart,
                      fmt::format("the driver offers OpenGL {}.{} and the kit needs {}.{}", offered.major,
                                  offered.minor, needed.major, needed.minor),
                      {}, "install Mesa 22.3 or newer");
  }
  // Found by its name: the list of binary formats is empty on Mesa although SPIR-V is taken.
  if (shader_input_ == GlShaderInput::kSpirv && gl_.ARB_gl_spirv == 0) {
    return setupError(kAttemptedStart, "the driver lacks GL_ARB_gl_spirv", text(GL_RENDERER),
                      "use the llvmpipe driver");
  }
  if (std::pair(offered.major, offered.minor) >= std::pair(4, 5)) {
    return {};
  }
  for (const Ability& ability : abilitiesOf(gl_)) {
    if (ability.present == 0) {
      return setupError(kAttemptedStart, fmt::format("the driver lacks {}", ability.extension),
                        text(GL_RENDERER), "install Mesa 22.3 or newer");
    }
  }
  return {};
}

const GladGLContext& GlSession::gl() const {
  context_->makeCurrent();
  return gl_;
}

std::string GlSession::text(GLenum name) const {
  const GLubyte* const value = gl().GetString(name);
  return value == nullptr ? std::string() : reinterpret_cast<const char*>(value);
}

int GlSession::integer(GLenum name) const {
  GLint value = 0;
  gl().GetIntegerv(name, &value);
  return value;
}

Expected<void> GlSession::failOnMessages(std::string_view attempted, std::string_view remedy) {
  std::vector<std::string> messages = drainMessages();
  if (messages.empty()) {
    return {};
  }
  auto failure = setupError(std::string(attempted), "the driver refused", {}, std::string(remedy));
  failure.value().reasons = std::move(messages);
  return failure;
}

void GlSession::setState() {
  messages_.listen(gl_);
  // Row 0 of every image in memory is the top: the shaders flip y once, so the lower left of GL is our upper
  // left.
  gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  // As Vulkan has it. The vertex that flat values come from is also the one that interpolation starts from,
  // so this decides the last bits of everything.
  gl_.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.Enable(GL_FRAMEBUFFER_SRGB);  // as Vulkan has it: the format alone decides
  gl_.Disable(GL_DITHER);
  gl_.Disable(GL_CULL_FACE);
}

}  // namespace ssrkit
