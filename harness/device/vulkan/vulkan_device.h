// The kit's device on Vulkan 1.3.
#pragma once

#include <memory>
#include <string_view>

#include "base/error.h"
#include "device/device.h"

namespace ssrkit {

// Opens the first physical device whose name contains `device_name_part` ("llvmpipe"; "" takes the first that
// can do the work). `id` becomes identity().id. The Vulkan loader is opened when this is called, so a program
// that never calls it does not need one. With SSRKIT_VALIDATION=1 in the environment the Khronos validation
// layer checks every call (core and synchronization); its messages come out of drainMessages(). Fails
// (kSetup) without a loader, a driver or a device that fits; the reasons list every device that was seen.
[[nodiscard]] Expected<std::unique_ptr<Device>> createVulkanDevice(std::string_view id,
                                                                   std::string_view device_name_part);

}  // namespace ssrkit
