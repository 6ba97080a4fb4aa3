// Which of the machine's Vulkan devices to use, and who it is.
#pragma once

#include <cstdint>

#include "base/error.h"
#include "device/device.h"
#include "device/vulkan/instance.h"
#include "device/vulkan/vulkan_device.h"

namespace ssrkit::vulkan {

struct PhysicalDevice {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceMemoryProperties memory{};
  std::uint32_t queue_family = 0;  // graphics
  std::uint32_t timestamp_valid_bits = 0;
  DeviceIdentity identity;  // all but the id
};

// The first device that fits the choice and can do the work. Fails (kSetup) with one reason a device.
[[nodiscard]] Expected<PhysicalDevice> pickPhysicalDevice(const Instance& instance,
                                                          const VulkanChoice& choice);

}  // namespace ssrkit::vulkan
