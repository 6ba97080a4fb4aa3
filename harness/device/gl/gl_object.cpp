#include "device/gl/gl_object.h"

#include <utility>

namespace ssrkit {

GlObject::GlObject(std::shared_ptr<GlSession> session, GLuint name, Delete remove)
    : session_(std::move(session)), name_(name), delete_(remove) {}

GlObject::~GlObject() {
  if (name_ != 0) {
    delete_(session_->gl(), name_);
  }
}

GlObject::GlObject(GlObject&& other) noexcept
    : session_(std::move(other.session_)), name_(std::exchange(other.name_, 0)), delete_(other.delete_) {}

GlObject& GlObject::operator=(GlObject&& other) noexcept {
  std::swap(session_, other.session_);
  std::swap(name_, other.name_);
  std::swap(delete_, other.delete_);
  return *this;
}

GlObject createTexture(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().CreateTextures(GL_TEXTURE_2D, 1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteTextures(1, &old); }};
}

GlObject createTextureName(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().GenTextures(1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteTextures(1, &old); }};
}

GlObject createBuffer(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().CreateBuffers(1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteBuffers(1, &old); }};
}

GlObject createFramebuffer(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().CreateFramebuffers(1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteFramebuffers(1, &old); }};
}

GlObject createVertexArray(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().CreateVertexArrays(1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteVertexArrays(1, &old); }};
}

GlObject createSampler(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().CreateSamplers(1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteSamplers(1, &old); }};
}

GlObject createTimestamp(const std::shared_ptr<GlSession>& session) {
  GLuint name = 0;
  session->gl().CreateQueries(GL_TIMESTAMP, 1, &name);
  return {session, name, [](const GladGLContext& gl, GLuint old) { gl.DeleteQueries(1, &old); }};
}

GlObject createShader(const std::shared_ptr<GlSession>& session, GLenum stage) {
  return {session, session->gl().CreateShader(stage),
          [](const GladGLContext& gl, GLuint old) { gl.DeleteShader(old); }};
}

GlObject createProgramObject(const std::shared_ptr<GlSession>& session) {
  return {session, session->gl().CreateProgram(),
          [](const GladGLContext& gl, GLuint old) { gl.DeleteProgram(old); }};
}

}  // namespace ssrkit
