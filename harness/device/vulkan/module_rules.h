// What spirv-val does not know of a module, because it depends on the pipeline and the device.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/error.h"
#include "device/vulkan/functions.h"

namespace ssrkit::vulkan {

// The module must have an entry point "main" of the stage, and no location past the device's limit. A driver
// or a validation layer need not survive either: layer 1.3.239 dereferences null at the first, Mesa 22.3
// writes past an array at the second. `words` have passed checkSpirv. Fails (kInput).
[[nodiscard]] Expected<void> checkModule(std::span<const std::uint32_t> words, VkShaderStageFlagBits stage,
                                         const VkPhysicalDeviceLimits& limits, const std::string& attempted);

}  // namespace ssrkit::vulkan
