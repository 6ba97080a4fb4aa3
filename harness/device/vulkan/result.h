// VkResult codes as names and errors.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace ssrkit::vulkan {

// "VK_ERROR_DEVICE_LOST"; a code that is not known here as "VkResult -123".
[[nodiscard]] std::string resultName(VkResult result);

// "could not ATTEMPTED: FUNCTION returned VK_ERROR_...", with a remedy where the code suggests one.
[[nodiscard]] tl::unexpected<Error> resultError(std::string attempted, std::string_view function,
                                                VkResult result);

// Hands the error of one Expected to another.
template <class T>
[[nodiscard]] tl::unexpected<Error> passOn(Expected<T>& failed) {
  return tl::make_unexpected(std::move(failed.error()));
}

}  // namespace ssrkit::vulkan
