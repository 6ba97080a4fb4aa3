#include "device/gl/gl_session.h"

#include <fmt/format.h>

namespace ssrkit {
namespace {

constexpr const char* kAttempted = "start OpenGL";

GLADapiproc findProcedure(void* context, const char* name) {
  return static_cast<const GlContext*>(context)->procedure(name);
}

}  // namespace

Expected<std::shared_ptr<GlSession>> GlSession::create(std::unique_ptr<GlContext> context) {
  std::shared_ptr<GlSession> session(new GlSession(std::move(context)));
  session->context_->makeCurrent();
  const int version = gladLoadGLContextUserPtr(&session->gl_, findProcedure, session->context_.get());
  if (version < GLAD_MAKE_VERSION(4, 5)) {
    return setupError(kAttempted,
                      fmt::format("the driver offers OpenGL {}.{} and the kit needs 4.5",
                                  GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)),
                      {}, "install Mesa 22.3 or newer");
  }
  // Found by its name: the list of binary formats is empty on Mesa although SPIR-V is taken.
  if (session->gl_.ARB_gl_spirv == 0) {
    return setupError(kAttempted, "the driver lacks GL_ARB_gl_spirv", session->text(GL_RENDERER),
                      "use the llvmpipe driver");
  }
  session->setState();
  return session;
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
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.Enable(GL_FRAMEBUFFER_SRGB);  // as Vulkan has it: the format alone decides
  gl_.Disable(GL_DITHER);
  gl_.Disable(GL_CULL_FACE);
  gl_.DepthFunc(GL_LESS);
}

}  // namespace ssrkit
