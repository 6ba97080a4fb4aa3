#include "device/gl/gl_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.h"
#include "device/gl/gl_stage.h"
#include "shader/glsl_translation.h"

namespace ssrkit {
namespace {

constexpr GLuint kVertexBinding = 0;

// Bindings index arrays of fixed size in the driver: it does not look before it leaps.
Expected<void> checkLimits(const GlSession& session, const ProgramDesc& desc) {
  const auto exceeds = [](std::span<const std::uint32_t> bindings, int limit) {
    return std::ranges::any_of(
        bindings, [limit](std::uint32_t binding) { return std::cmp_greater_equal(binding, limit); });
  };
  const std::string attempted = fmt::format("load the program '{}'", desc.name);
  const int sampler_limit = session.integer(GL_MAX_TEXTURE_IMAGE_UNITS);
  if (exceeds(desc.sampler_bindings, sampler_limit)) {
    return inputError(attempted,
                      fmt::format("OpenGL has samplers at bindings 0 to {} only", sampler_limit - 1), {},
                      "choose a smaller binding");
  }
  const int block_limit = session.integer(GL_MAX_UNIFORM_BUFFER_BINDINGS);
  if (exceeds(desc.uniform_bindings, block_limit)) {
    return inputError(attempted,
                      fmt::format("OpenGL has uniform blocks at bindings 0 to {} only", block_limit - 1), {},
                      "choose a smaller binding");
  }
  const int target_limit = session.integer(GL_MAX_DRAW_BUFFERS);
  if (std::cmp_greater(desc.colour_formats.size(), target_limit)) {
    return inputError(attempted, fmt::format("it draws to {} images and OpenGL allows {}",
                                             desc.colour_formats.size(), target_limit));
  }
  return {};
}

std::string programLog(const GladGLContext& gl, GLuint program) {
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
  gl.GetProgramInfoLog(program, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log;
}

GLint componentCount(VertexFormat format) {
  switch (format) {
    case VertexFormat::kFloat1:
      return 1;
    case VertexFormat::kFloat2:
      return 2;
    case VertexFormat::kFloat3:
      return 3;
    case VertexFormat::kFloat4:
      return 4;
  }
  SSRKIT_CHECK(false);
}

// Text that came from SPIR-V says nothing of bindings before GLSL 420; its names do.
void bindByName(const GladGLContext& gl, GLuint program, const ProgramDesc& desc) {
  gl.UseProgram(program);
  for (const std::uint32_t binding : desc.sampler_bindings) {
    const GLint location = gl.GetUniformLocation(program, glslSamplerName(binding).c_str());
    if (location >= 0) {  // else the compiler found no use of it
      gl.Uniform1i(location, static_cast<GLint>(binding));
    }
  }
  for (const std::uint32_t binding : desc.uniform_bindings) {
    const GLuint index = gl.GetUniformBlockIndex(program, glslBlockName(binding).c_str());
    if (index != GL_INVALID_INDEX) {
      gl.UniformBlockBinding(program, index, binding);
    }
  }
}

GlObject createLayout(const std::shared_ptr<GlSession>& session,
                      std::span<const VertexAttribute> attributes) {
  GlObject object = createVertexArray(session);
  const GladGLContext& gl = session->gl();
  for (const VertexAttribute& attribute : attributes) {
    gl.EnableVertexArrayAttrib(object.name(), attribute.location);
    gl.VertexArrayAttribFormat(object.name(), attribute.location, componentCount(attribute.format), GL_FLOAT,
                               GL_FALSE, attribute.offset_bytes);
    gl.VertexArrayAttribBinding(object.name(), attribute.location, kVertexBinding);
  }
  return object;
}

}  // namespace

Expected<std::unique_ptr<GlProgram>> GlProgram::create(const std::shared_ptr<GlSession>& session,
                                                       const ProgramDesc& desc) {
  if (const auto fits = checkLimits(*session, desc); !fits) {
    return tl::unexpected(fits.error());
  }
  const Expected<GlObject> vertex =
      loadGlStage(session, desc, {GL_VERTEX_SHADER, "vertex", desc.vertex_spirv, desc.vertex_constant_ids});
  if (!vertex) {
    return tl::unexpected(vertex.error());
  }
  const Expected<GlObject> fragment = loadGlStage(
      session, desc, {GL_FRAGMENT_SHADER, "fragment", desc.fragment_spirv, desc.fragment_constant_ids});
  if (!fragment) {
    return tl::unexpected(fragment.error());
  }
  const GladGLContext& gl = session->gl();
  GlObject program = createProgramObject(session);
  gl.AttachShader(program.name(), vertex->name());
  gl.AttachShader(program.name(), fragment->name());
  gl.LinkProgram(program.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    return refusedShaders(*session, fmt::format("link the program '{}'", desc.name),
                          programLog(gl, program.name()));
  }
  gl.DetachShader(program.name(), vertex->name());
  gl.DetachShader(program.name(), fragment->name());
  if (session->shaderInput() != GlShaderInput::kSpirv) {
    bindByName(gl, program.name(), desc);
  }
  return std::unique_ptr<GlProgram>(
      new GlProgram(layoutOf(desc), std::move(program), createLayout(session, desc.vertex_attributes)));
}

}  // namespace ssrkit
