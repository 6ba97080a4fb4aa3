#include "device/vulkan/result.h"

#include <fmt/format.h>

namespace ssrkit::vulkan {

std::string resultName(VkResult result) {
  switch (result) {
#define SSRKIT_NAME(code) \
  case code:              \
    return #code;
    SSRKIT_NAME(VK_SUCCESS)
    SSRKIT_NAME(VK_NOT_READY)
    SSRKIT_NAME(VK_TIMEOUT)
    SSRKIT_NAME(VK_INCOMPLETE)
    SSRKIT_NAME(VK_ERROR_OUT_OF_HOST_MEMORY)
    SSRKIT_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY)
    SSRKIT_NAME(VK_ERROR_INITIALIZATION_FAILED)
    SSRKIT_NAME(VK_ERROR_DEVICE_LOST)
    SSRKIT_NAME(VK_ERROR_MEMORY_MAP_FAILED)
    SSRKIT_NAME(VK_ERROR_LAYER_NOT_PRESENT)
    SSRKIT_NAME(VK_ERROR_EXTENSION_NOT_PRESENT)
    SSRKIT_NAME(VK_ERROR_FEATURE_NOT_PRESENT)
    SSRKIT_NAME(VK_ERROR_INCOMPATIBLE_DRIVER)
    SSRKIT_NAME(VK_ERROR_TOO_MANY_OBJECTS)
    SSRKIT_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED)
    SSRKIT_NAME(VK_ERROR_FRAGMENTED_POOL)
    SSRKIT_NAME(VK_ERROR_UNKNOWN)
    SSRKIT_NAME(VK_ERROR_OUT_OF_POOL_MEMORY)
    SSRKIT_NAME(VK_ERROR_FRAGMENTATION)
    SSRKIT_NAME(VK_PIPELINE_COMPILE_REQUIRED)
    SSRKIT_NAME(VK_ERROR_VALIDATION_FAILED_EXT)
    SSRKIT_NAME(VK_ERROR_INVALID_SHADER_NV)
#undef SSRKIT_NAME
    default:
      return fmt::format("VkResult {}", static_cast<int>(result));
  }
}

tl::unexpected<Error> resultError(std::string attempted, std::string_view function, VkResult result) {
  std::string remedy;
  if (result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY) {
    remedy = "use a smaller image size or free some memory";
  } else if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
    remedy = "install a Vulkan driver (Debian: mesa-vulkan-drivers) and check VK_DRIVER_FILES";
  }
  return setupError(std::move(attempted), fmt::format("{} returned {}", function, resultName(result)), {},
                    std::move(remedy));
}

}  // namespace ssrkit::vulkan
