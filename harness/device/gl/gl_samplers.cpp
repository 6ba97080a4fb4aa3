#include "device/gl/gl_samplers.h"

#include "base/check.h"

namespace ssrkit {
namespace {

GLint wrapMode(AddressMode mode) {
  switch (mode) {
    case AddressMode::kClamp:
      return GL_CLAMP_TO_EDGE;
    case AddressMode::kRepeat:
      return GL_REPEAT;
    case AddressMode::kMirror:
      return GL_MIRRORED_REPEAT;
  }
  SSRKIT_CHECK(false);
}

}  // namespace

GLuint GlSamplers::find(const SampledImage& sampled) {
  const auto [entry, is_new] = samplers_.try_emplace({sampled.filter, sampled.address_u, sampled.address_v});
  if (is_new) {
    entry->second = createSampler(session_);
    const GladGLContext& gl = session_->gl();
    const GLuint sampler = entry->second.name();
    const bool is_linear = sampled.filter == Filter::kLinear;
    gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER,
                         is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST);
    gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, is_linear ? GL_LINEAR : GL_NEAREST);
    gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, wrapMode(sampled.address_u));
    gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_T, wrapMode(sampled.address_v));
  }
  return entry->second.name();
}

}  // namespace ssrkit
