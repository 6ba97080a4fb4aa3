#include "device/spirv_check.h"

#include <fmt/format.h>

#include <memory>
#include <spirv-tools/libspirv.hpp>
#include <string>
#include <vector>

namespace ssrkit {

Expected<void> checkSpirv(std::string_view program, std::string_view stage,
                          std::span<const std::uint32_t> words, SpirvEnvironment environment) {
  std::vector<std::string> reasons;
  spvtools::SpirvTools checker(environment == SpirvEnvironment::kOpenGl45 ? SPV_ENV_OPENGL_4_5
                                                                          : SPV_ENV_VULKAN_1_1);
  checker.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t& position, const char* message) {
        reasons.push_back(fmt::format("word {}: {}", position.index, message));
      });
  if (words.empty() || !checker.Validate(words.data(), words.size())) {
    Error error = inputError(fmt::format("load the {} shader of '{}'", stage, program),
                             reasons.empty() ? "the module is empty" : "the module is not valid SPIR-V")
                      .value();
    error.reasons = std::move(reasons);
    return tl::unexpected(std::move(error));
  }
  return {};
}

}  // namespace ssrkit
