// A GL name that deletes itself, in its own context.
#pragma once

#include <glad/gl.h>

#include <memory>

#include "device/gl/gl_session.h"

namespace ssrkit {

class GlObject {
 public:
  using Delete = void (*)(const GladGLContext& gl, GLuint name);

  GlObject() = default;
  GlObject(std::shared_ptr<GlSession> session, GLuint name, Delete remove);
  ~GlObject();
  GlObject(GlObject&& other) noexcept;
  GlObject& operator=(GlObject&& other) noexcept;

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  std::shared_ptr<GlSession> session_;
  GLuint name_ = 0;
  Delete delete_ = nullptr;
};

[[nodiscard]] GlObject createTexture(const std::shared_ptr<GlSession>& session);
// A name alone, as glTextureView wants it.
[[nodiscard]] GlObject createTextureName(const std::shared_ptr<GlSession>& session);
[[nodiscard]] GlObject createBuffer(const std::shared_ptr<GlSession>& session);
[[nodiscard]] GlObject createFramebuffer(const std::shared_ptr<GlSession>& session);
[[nodiscard]] GlObject createVertexArray(const std::shared_ptr<GlSession>& session);
[[nodiscard]] GlObject createSampler(const std::shared_ptr<GlSession>& session);
[[nodiscard]] GlObject createTimestamp(const std::shared_ptr<GlSession>& session);
[[nodiscard]] GlObject createShader(const std::shared_ptr<GlSession>& session, GLenum stage);
[[nodiscard]] GlObject createProgramObject(const std::shared_ptr<GlSession>& session);

}  // namespace ssrkit
