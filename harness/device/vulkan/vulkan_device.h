// The kit's device on Vulkan 1.3.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/error.h"
#include "device/device.h"

namespace ssrkit {

struct VulkanChoice {
  std::string device_name_part;                        // "llvmpipe"; "" takes any that can do the work
  bool wants_gpu = false;                              // not a device that runs on the processor
  std::string driver_package = "mesa-vulkan-drivers";  // Debian's, for the message where none fits
};

// Opens the first physical device that fits. `id` becomes identity().id. The Vulkan loader is opened when
// this is called, so a program that never calls it does not need one. With SSRKIT_VALIDATION in the
// environment ("core,sync,gpu" or a part of it; "1": core and sync) the Khronos validation layer checks every
// call; its messages come out of drainMessages(). Fails (kSetup) without a loader, a driver or a device that
// fits; the reasons list every device that was seen.
[[nodiscard]] Expected<std::unique_ptr<Device>> createVulkanDevice(std::string_view id,
                                                                   const VulkanChoice& choice);

}  // namespace ssrkit
