#include "shader/glsl_translation.h"

#include <fmt/format.h>

#include <exception>
#include <spirv_cross/spirv_glsl.hpp>
#include <string>

namespace ssrkit {

namespace {

constexpr const char* kAttempted = "translate SPIR-V to GLSL";

std::uint32_t versionNumber(GlslVersion version) {
  return version == GlslVersion::k330 ? 330 : 450;
}

void setConstants(spirv_cross::CompilerGLSL& compiler, std::span<const GlslConstant> constants) {
  for (const spirv_cross::SpecializationConstant& declared : compiler.get_specialization_constants()) {
    for (const GlslConstant& constant : constants) {
      if (constant.id == declared.constant_id) {
        compiler.get_constant(declared.id).m.c[0].r[0].u32 = constant.bits;
      }
    }
  }
}

void nameVariables(spirv_cross::CompilerGLSL& compiler,
                   const spirv_cross::SmallVector<spirv_cross::Resource>& variables) {
  for (const spirv_cross::Resource& variable : variables) {
    compiler.set_name(
        variable.id,
        fmt::format("ssrkit_varying_{}", compiler.get_decoration(variable.id, spv::DecorationLocation)));
  }
}

void nameInterface(spirv_cross::CompilerGLSL& compiler) {
  const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
  for (const spirv_cross::Resource& sampler : resources.sampled_images) {
    compiler.set_name(sampler.id,
                      glslSamplerName(compiler.get_decoration(sampler.id, spv::DecorationBinding)));
  }
  for (const spirv_cross::Resource& block : resources.uniform_buffers) {
    const std::uint32_t binding = compiler.get_decoration(block.id, spv::DecorationBinding);
    compiler.set_name(block.base_type_id, glslBlockName(binding));
    compiler.set_name(block.id, glslBlockName(binding) + "_members");
  }
  const bool is_vertex = compiler.get_execution_model() == spv::ExecutionModelVertex;
  nameVariables(compiler, is_vertex ? resources.stage_outputs : resources.stage_inputs);
}

spirv_cross::CompilerGLSL::Options optionsFor(GlslVersion version) {
  spirv_cross::CompilerGLSL::Options options;
  options.version = versionNumber(version);
  options.es = false;
  options.vulkan_semantics = false;
  options.separate_shader_objects = false;
  options.enable_420pack_extension = false;
  return options;
}

}  // namespace

Expected<std::string> translateToGlsl(std::span<const std::uint32_t> spirv, GlslVersion version,
                                      std::span<const GlslConstant> constants) {
  try {
    spirv_cross::CompilerGLSL compiler(spirv.data(), spirv.size());
    if (compiler.get_execution_mode_bitset().get(spv::ExecutionModeOriginUpperLeft)) {
      return inputError(kAttempted, "the module was made for Vulkan: its rows are numbered from the top", {},
                        "compile it for OpenGL");
    }
    compiler.set_common_options(optionsFor(version));
    setConstants(compiler, constants);
    nameInterface(compiler);
    return compiler.compile();
  } catch (const std::exception& error) {  // SPIRV-Cross reports by exceptions
    return inputError(kAttempted,
                      fmt::format("GLSL {} cannot say it: {}", versionNumber(version), error.what()));
  }
}

std::string glslSamplerName(std::uint32_t binding) {
  return fmt::format("ssrkit_sampler_{}", binding);
}

std::string glslBlockName(std::uint32_t binding) {
  return fmt::format("ssrkit_block_{}", binding);
}

}  // namespace ssrkit
