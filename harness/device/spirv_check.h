// Guards a driver against SPIR-V that would crash it: Mesa's front ends trust their input.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/error.h"

namespace ssrkit {

enum class SpirvEnvironment { kOpenGl45, kVulkan11 };

// Runs spirv-val's rules of the environment. `program` and `stage` ("vertex") are for the message.
[[nodiscard]] Expected<void> checkSpirv(std::string_view program, std::string_view stage,
                                        std::span<const std::uint32_t> words, SpirvEnvironment environment);

}  // namespace ssrkit
