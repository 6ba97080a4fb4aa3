// A GL context with its entry points and the state that never changes. Every GL object holds on to it.
#pragma once

#include <glad/gl.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "device/gl/gl_context.h"
#include "device/gl/gl_messages.h"
#include "device/gl/gl_shader_input.h"

namespace ssrkit {

class GlSession {
 public:
  // Fails when the context lacks what the kit calls, or does not take shaders in this way.
  [[nodiscard]] static Expected<std::shared_ptr<GlSession>> create(
      std::unique_ptr<GlContext> context, GlShaderInput input = GlShaderInput::kSpirv);

  GlSession(const GlSession&) = delete;
  GlSession& operator=(const GlSession&) = delete;
  ~GlSession() = default;

  // The entry points, with the context made current.
  [[nodiscard]] const GladGLContext& gl() const;
  [[nodiscard]] GlShaderInput shaderInput() const { return shader_input_; }
  [[nodiscard]] std::string text(GLenum name) const;
  [[nodiscard]] int integer(GLenum name) const;
  [[nodiscard]] std::vector<std::string> drainMessages() { return messages_.drain(gl()); }

  // A set-up error with the driver's messages as its reasons when there are any.
  [[nodiscard]] Expected<void> failOnMessages(std::string_view attempted, std::string_view remedy);

 private:
  GlSession(std::unique_ptr<GlContext> context, GlShaderInput input)
      : context_(std::move(context)), shader_input_(input) {}
  [[nodiscard]] Expected<void> checkAbilities(GlVersion offered) const;
  void setState();

  GlMessages messages_;  // outlives the context, which reports to it
  std::unique_ptr<GlContext> context_;
  GlShaderInput shader_input_;
  GladGLContext gl_{};
};

}  // namespace ssrkit
