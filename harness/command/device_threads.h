#pragma once

#include <string>

#include "base/error.h"
#include "device/registry.h"

namespace ssrkit {

// A device by its id, or "vk-lavapipe@1": the device, its software rasteriser held to one thread (Mesa's
// LP_NUM_THREADS).
[[nodiscard]] Expected<DeviceEntry> deviceWithThreads(const std::string& name);

// False also for a name that is no device's.
[[nodiscard]] bool isVulkanDevice(const std::string& name);

}  // namespace ssrkit
