#include "device/gl/gl_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "device/spirv_check.h"
#include "shader/glsl_translation.h"

namespace ssrkit {
namespace {

std::string shaderLog(const GladGLContext& gl, GLuint shader) {
  GLint length = 0;
  gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
  gl.GetShaderInfoLog(shader, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log;
}

// Those that this stage declares: another id would be GL_INVALID_VALUE.
std::vector<SpecConstant> constantsOf(const ProgramDesc& desc, const GlStageSource& source) {
  std::vector<SpecConstant> own;
  std::ranges::copy_if(desc.spec_constants, std::back_inserter(own), [&](const SpecConstant& constant) {
    return std::ranges::find(source.constant_ids, constant.id) != source.constant_ids.end();
  });
  return own;
}

void giveSpirv(const GladGLContext& gl, GLuint shader, const GlStageSource& source,
               std::span<const SpecConstant> constants) {
  std::vector<GLuint> ids;
  std::vector<GLuint> values;
  for (const SpecConstant& constant : constants) {
    ids.push_back(constant.id);
    values.push_back(constant.bits);
  }
  gl.ShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V_ARB, source.spirv.data(),
                  static_cast<GLsizei>(source.spirv.size_bytes()));
  gl.SpecializeShaderARB(shader, "main", static_cast<GLuint>(ids.size()), ids.data(), values.data());
}

Expected<void> giveGlsl(const GladGLContext& gl, GLuint shader, const GlStageSource& source,
                        GlslVersion version, std::span<const SpecConstant> constants) {
  std::vector<GlslConstant> values;
  for (const SpecConstant& constant : constants) {
    values.push_back({.id = constant.id, .bits = constant.bits});
  }
  const Expected<std::string> glsl = translateToGlsl(source.spirv, version, values);
  if (!glsl) {
    return tl::unexpected(glsl.error());
  }
  const char* const text = glsl->c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  return {};
}

}  // namespace

tl::unexpected<Error> refusedShaders(GlSession& session, std::string attempted, std::string_view log) {
  auto failure = inputError(std::move(attempted), "the driver refused the shaders");
  std::vector<std::string> reasons = session.drainMessages();
  if (!log.empty()) {
    reasons.insert(reasons.begin(), std::string(log));
  }
  failure.value().reasons = std::move(reasons);
  return failure;
}

Expected<GlObject> loadGlStage(const std::shared_ptr<GlSession>& session, const ProgramDesc& desc,
                               const GlStageSource& source) {
  if (const auto valid = checkSpirv(desc.name, source.name, source.spirv, SpirvEnvironment::kOpenGl45);
      !valid) {
    return tl::unexpected(valid.error());
  }
  const GladGLContext& gl = session->gl();
  GlObject object = createShader(session, source.stage);
  const std::vector<SpecConstant> constants = constantsOf(desc, source);
  if (session->shaderInput() == GlShaderInput::kSpirv) {
    giveSpirv(gl, object.name(), source, constants);
  } else {
    const GlslVersion version =
        session->shaderInput() == GlShaderInput::kGlsl330 ? GlslVersion::k330 : GlslVersion::k450;
    if (const auto given = giveGlsl(gl, object.name(), source, version, constants); !given) {
      Error error = given.error();
      error.attempted = fmt::format("{} (the {} shader of '{}')", error.attempted, source.name, desc.name);
      return tl::unexpected(std::move(error));
    }
  }
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(object.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    return refusedShaders(*session, fmt::format("specialise the {} shader of '{}'", source.name, desc.name),
                          shaderLog(gl, object.name()));
  }
  return object;
}

}  // namespace ssrkit
