#include "device/gl/gl_messages.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace ssrkit {
namespace {

// What a compiler warns of is in text that a translation made, and not in the author's.
bool matters(GLenum source, GLenum type, GLenum severity) {
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER && type != GL_DEBUG_TYPE_ERROR) {
    return false;
  }
  return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
         severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
}

const char* errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "unknown error";
  }
}

void GLAD_API_PTR keepMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                              const GLchar* text, const void* user) {
  if (!matters(source, type, severity)) {
    return;
  }
  const std::string_view message =
      length < 0 ? std::string_view(text) : std::string_view(text, static_cast<std::size_t>(length));
  // The pointer was given to glDebugMessageCallback as a mutable vector; its signature adds the const.
  auto* const messages =
      const_cast<std::vector<std::string>*>(static_cast<const std::vector<std::string>*>(user));
  messages->push_back(fmt::format("OpenGL message {}: {}", id, message));
}

}  // namespace

void GlMessages::listen(const GladGLContext& gl) {
  gl.Enable(GL_DEBUG_OUTPUT);
  gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl.DebugMessageCallback(keepMessage, &messages_);
}

std::vector<std::string> GlMessages::drain(const GladGLContext& gl) {
  // The bound matters: a lost context may report errors for ever.
  constexpr int kMostErrors = 16;
  for (int i = 0; i < kMostErrors; ++i) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) {
      break;
    }
    messages_.push_back(fmt::format("glGetError: {} (0x{:x})", errorName(error), error));
  }
  return std::exchange(messages_, {});
}

}  // namespace ssrkit
