#include "device/gl/gl_pass.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "device/gl/gl_buffer.h"
#include "device/gl/gl_formats.h"
#include "device/gl/gl_image.h"
#include "device/gl/gl_object.h"
#include "device/gl/gl_program.h"
#include "device/pass_clock.h"
#include "device/pass_rules.h"

namespace ssrkit {
namespace {

Expected<GlObject> createTarget(const std::shared_ptr<GlSession>& session, const PassDesc& pass) {
  const GladGLContext& gl = session->gl();
  GlObject target = createFramebuffer(session);
  std::vector<GLenum> draw_buffers;
  for (const Attachment& attachment : pass.colour) {
    const auto point = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + draw_buffers.size());
    gl.NamedFramebufferTexture(target.name(), point, glImage(*attachment.image).texture(), attachment.mip);
    draw_buffers.push_back(point);
  }
  gl.NamedFramebufferDrawBuffers(target.name(), static_cast<GLsizei>(draw_buffers.size()),
                                 draw_buffers.data());
  if (pass.depth) {
    gl.NamedFramebufferTexture(target.name(), GL_DEPTH_ATTACHMENT, glImage(*pass.depth->image).texture(),
                               pass.depth->mip);
  }
  const GLenum status = gl.CheckNamedFramebufferStatus(target.name(), GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    return setupError(fmt::format("draw the pass '{}'", pass.name),
                      fmt::format("the driver cannot draw to these images together (status 0x{:x})", status));
  }
  return target;
}

template <class Component>
std::array<Component, 4> rounded(const std::array<double, 4>& values) {
  std::array<Component, 4> result{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    result[i] = static_cast<Component>(std::llround(values[i]));
  }
  return result;
}

void clearColour(const GladGLContext& gl, GLuint target, GLint index, Format format,
                 const std::array<double, 4>& value) {
  const GLenum component = glFormat(format).component;
  if (!formatInfo(format).is_integer) {
    std::array<GLfloat, 4> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<GLfloat>(value[i]);
    }
    gl.ClearNamedFramebufferfv(target, GL_COLOR, index, values.data());
  } else if (component == GL_SHORT) {
    gl.ClearNamedFramebufferiv(target, GL_COLOR, index, rounded<GLint>(value).data());
  } else {
    gl.ClearNamedFramebufferuiv(target, GL_COLOR, index, rounded<GLuint>(value).data());
  }
}

// Clears are of the whole mip, whatever the viewport.
void clearTarget(const GladGLContext& gl, GLuint target, const PassDesc& pass) {
  gl.Disable(GL_SCISSOR_TEST);
  for (std::size_t i = 0; i < pass.colour.size(); ++i) {
    const Attachment& attachment = pass.colour[i];
    if (attachment.clear) {
      clearColour(gl, target, static_cast<GLint>(i), attachment.image->desc().format, *attachment.clear);
    }
  }
  if (pass.depth && pass.depth->clear) {
    gl.DepthMask(GL_TRUE);
    const auto value = static_cast<GLfloat>((*pass.depth->clear)[0]);
    gl.ClearNamedFramebufferfv(target, GL_DEPTH, 0, &value);
  }
}

void bindSampled(const GladGLContext& gl, GlSamplers& samplers, std::span<const SampledImage> sampled) {
  for (const SampledImage& image : sampled) {
    gl.BindTextureUnit(image.binding, glImage(*image.image).view(image.base_mip, image.mip_count));
    gl.BindSampler(image.binding, samplers.find(image));
  }
}

GlObject createUniforms(const std::shared_ptr<GlSession>& session, std::span<const std::byte> bytes) {
  GlObject buffer = createBuffer(session);
  session->gl().NamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
  return buffer;
}

void setDepthTest(const GladGLContext& gl, DepthTest test) {
  if (test == DepthTest::kNone) {
    gl.Disable(GL_DEPTH_TEST);
    return;
  }
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(test == DepthTest::kNearer ? GL_LESS : GL_GREATER);
  gl.DepthMask(test == DepthTest::kNearer ? GL_TRUE : GL_FALSE);
}

void bindProgram(const GladGLContext& gl, const PassDesc& pass, const GlProgram& program) {
  const ProgramLayout& layout = program.layout();
  gl.UseProgram(program.program());
  gl.BindVertexArray(program.vertexArray());
  if (pass.vertices != nullptr) {
    const auto* const vertices = dynamic_cast<const GlVertexBuffer*>(pass.vertices);
    SSRKIT_CHECK(vertices != nullptr);
    checkVertexRanges(pass, layout, vertices->byteCount());
    gl.VertexArrayVertexBuffer(program.vertexArray(), 0, vertices->buffer(), 0,
                               static_cast<GLsizei>(layout.vertex_stride_bytes));
  }
  setDepthTest(gl, layout.depth_test);
}

}  // namespace

Expected<PassTime> drawGlPass(const std::shared_ptr<GlSession>& session, GlSamplers& samplers,
                              GlTimestamps& timestamps, const PassDesc& pass) {
  const auto* const program = dynamic_cast<const GlProgram*>(pass.program);
  SSRKIT_CHECK(program != nullptr);
  if (const auto valid = checkPass(pass, program->layout()); !valid) {
    return tl::unexpected(valid.error());
  }
  const Expected<GlObject> target = createTarget(session, pass);
  if (!target) {
    return tl::unexpected(target.error());
  }
  const GladGLContext& gl = session->gl();
  GlObject uniforms;
  if (!pass.uniforms.empty()) {
    uniforms = createUniforms(session, pass.uniforms);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, pass.uniform_binding, uniforms.name());
  }
  bindProgram(gl, pass, *program);
  bindSampled(gl, samplers, pass.sampled);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target->name());
  gl.Viewport(pass.viewport.x, pass.viewport.y, pass.viewport.width, pass.viewport.height);
  const Rect scissor = pass.scissor.value_or(pass.viewport);
  gl.Scissor(scissor.x, scissor.y, scissor.width, scissor.height);

  const PassClock clock;
  timestamps.begin();
  clearTarget(gl, target->name(), pass);
  gl.Enable(GL_SCISSOR_TEST);
  for (const DrawCall& draw : pass.draws) {
    bindSampled(gl, samplers, draw.sampled);
    gl.DrawArrays(GL_TRIANGLES, static_cast<GLint>(draw.first_vertex),
                  static_cast<GLsizei>(draw.vertex_count));
  }
  timestamps.end();
  gl.Finish();
  // Zink's glFinish returns before work that an earlier flush has sent off is done; the second stamp is not
  // there before it is.
  const std::int64_t device_ns = timestamps.elapsedNs();
  PassTime time = clock.elapsed();
  time.device_ns = device_ns;
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return time;
}

}  // namespace ssrkit
