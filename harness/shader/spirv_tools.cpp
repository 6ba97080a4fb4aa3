#include "shader/spirv_tools.h"

#include <fmt/format.h>

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include <utility>

#include "shader/module_variants.h"

namespace ssrkit {

namespace {

spv_target_env environmentOf(ShaderTarget target) {
  return target == ShaderTarget::kVulkan ? SPV_ENV_VULKAN_1_1 : SPV_ENV_OPENGL_4_5;
}

spvtools::MessageConsumer collectInto(std::vector<std::string>& messages) {
  return [&messages](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
    if (level <= SPV_MSG_ERROR) {
      messages.emplace_back(message);
    }
  };
}

void registerPasses(spvtools::Optimizer& optimiser, ModuleForm form) {
  switch (form) {
    case ModuleForm::kPlain:
    case ModuleForm::kDeadCode:
    case ModuleForm::kCountedLoops:
    case ModuleForm::kUniformsReversed:
      break;
    case ModuleForm::kOptimised:
      optimiser.RegisterPerformancePasses();
      break;
    case ModuleForm::kOptimisedSize:
      optimiser.RegisterSizePasses();
      break;
    case ModuleForm::kRobust:
      optimiser.RegisterPass(spvtools::CreateGraphicsRobustAccessPass());
      break;
  }
}

tl::unexpected<Error> refused(std::string problem, std::vector<std::string> reasons, const std::string& where,
                              const std::string& attempted) {
  tl::unexpected<Error> error = inputError(attempted, std::move(problem), where);
  error.value().reasons = std::move(reasons);
  return error;
}

}  // namespace

Expected<void> validateSpirv(const std::vector<std::uint32_t>& spirv, ShaderTarget target,
                             const std::string& where, const std::string& attempted) {
  std::vector<std::string> messages;
  spvtools::SpirvTools tools(environmentOf(target));
  tools.SetMessageConsumer(collectInto(messages));
  if (tools.Validate(spirv)) {
    return {};
  }
  const std::string first = messages.empty() ? "no reason given" : messages.front();
  return refused(fmt::format("the SPIR-V is not legal there: {}", first), std::move(messages), where,
                 attempted);
}

Expected<std::vector<std::uint32_t>> rewriteSpirv(const std::vector<std::uint32_t>& spirv, ModuleForm form,
                                                  ShaderTarget target, const std::string& where,
                                                  const std::string& attempted) {
  if (form == ModuleForm::kDeadCode) {
    return withDeadCode(spirv);
  }
  if (form == ModuleForm::kCountedLoops) {
    return withCountedLoops(spirv);
  }
  if (form == ModuleForm::kUniformsReversed) {
    return withUniformsReversed(spirv);
  }
  std::vector<std::string> messages;
  spvtools::Optimizer optimiser(environmentOf(target));
  optimiser.SetMessageConsumer(collectInto(messages));
  registerPasses(optimiser, form);
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);  // validated before and after
  options.set_preserve_bindings(true);
  options.set_preserve_spec_constants(true);
  std::vector<std::uint32_t> optimised;
  if (optimiser.Run(spirv.data(), spirv.size(), &optimised, options)) {
    return optimised;
  }
  return refused("the SPIR-V optimiser failed on it", std::move(messages), where, attempted);
}

Expected<std::string> disassembleSpirv(const std::vector<std::uint32_t>& spirv, ShaderTarget target,
                                       const std::string& attempted) {
  std::vector<std::string> messages;
  spvtools::SpirvTools tools(environmentOf(target));
  tools.SetMessageConsumer(collectInto(messages));
  std::string text;
  if (tools.Disassemble(spirv, &text,
                        SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES | SPV_BINARY_TO_TEXT_OPTION_INDENT)) {
    return text;
  }
  return refused("it is no SPIR-V", std::move(messages), "", attempted);
}

std::string spirvToolsVersion() {
  return fmt::format("SPIRV-Tools {}", spvSoftwareVersionString());
}

}  // namespace ssrkit
