#include "device/vulkan/gpu.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "device/vulkan/result.h"

namespace ssrkit::vulkan {

namespace {

// Robust access makes an out-of-range read of a user's shader a defined value instead of somebody else's
// memory.
struct Features {
  VkPhysicalDeviceVulkan13Features core13{};
  VkPhysicalDeviceFeatures2 core{};

  Features() {
    core13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    core.pNext = &core13;
  }
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;

  void enableFrom(const Features& present) {
    core13.dynamicRendering = VK_TRUE;
    core13.synchronization2 = VK_TRUE;
    core13.robustImageAccess = present.core13.robustImageAccess;
    core.features.robustBufferAccess = present.core.features.robustBufferAccess;
    core.features.shaderImageGatherExtended = present.core.features.shaderImageGatherExtended;
  }
};

}  // namespace

Gpu::Gpu(std::unique_ptr<Instance> instance, PhysicalDevice physical)
    : instance_(std::move(instance)), physical_(std::move(physical)) {}

Expected<std::shared_ptr<Gpu>> Gpu::create(std::unique_ptr<Instance> instance, PhysicalDevice physical) {
  std::shared_ptr<Gpu> gpu(new Gpu(std::move(instance), std::move(physical)));
  Expected<void> done = gpu->createDevice();
  if (done) {
    done = gpu->loadFunctions();
  }
  if (!done) {
    return passOn(done);
  }
  gpu->functions_.vkGetDeviceQueue(gpu->device_, gpu->physical_.queue_family, 0, &gpu->queue_);
  return gpu;
}

Expected<void> Gpu::createDevice() {
  Features present;
  instance_->functions().vkGetPhysicalDeviceFeatures2(physical_.handle, &present.core);
  Features enabled;
  enabled.enableFrom(present);
  // GPU-assisted validation reports what robust access would hide, and stores what it finds.
  if (instance_->checks().gpu) {
    enabled.core.features.robustBufferAccess = VK_FALSE;
    enabled.core.features.fragmentStoresAndAtomics = present.core.features.fragmentStoresAndAtomics;
    enabled.core.features.vertexPipelineStoresAndAtomics =
        present.core.features.vertexPipelineStoresAndAtomics;
  }

  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = physical_.queue_family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;

  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &enabled.core;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  const VkResult result = instance_->functions().vkCreateDevice(physical_.handle, &info, nullptr, &device_);
  if (result != VK_SUCCESS) {
    device_ = VK_NULL_HANDLE;
    return resultError(fmt::format("open the Vulkan device '{}'", physical_.identity.driver),
                       "vkCreateDevice", result);
  }
  return {};
}

Expected<void> Gpu::loadFunctions() {
  const PFN_vkGetDeviceProcAddr address_of = instance_->functions().vkGetDeviceProcAddr;
#define SSRKIT_LOAD(name)                                                                    \
  functions_.name = reinterpret_cast<PFN_##name>(address_of(device_, #name));                \
  if (functions_.name == nullptr) {                                                          \
    return setupError(fmt::format("open the Vulkan device '{}'", physical_.identity.driver), \
                      "its driver has no " #name, {}, "update the driver");                  \
  }
  SSRKIT_VULKAN_DEVICE_FUNCTIONS(SSRKIT_LOAD)
#undef SSRKIT_LOAD
  return {};
}

Gpu::~Gpu() {
  if (device_ == VK_NULL_HANDLE) {
    return;
  }
  if (functions_.vkDeviceWaitIdle != nullptr) {
    functions_.vkDeviceWaitIdle(device_);
  }
  if (functions_.vkDestroyDevice != nullptr) {
    functions_.vkDestroyDevice(device_, nullptr);
  }
}

void Gpu::nameObject(VkObjectType type, std::uint64_t handle, const std::string& name) const {
  const auto set_name = instance_->functions().vkSetDebugUtilsObjectNameEXT;
  if (!instance_->checks().any() || set_name == nullptr) {
    return;
  }
  VkDebugUtilsObjectNameInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = name.c_str();
  set_name(device_, &info);
}

}  // namespace ssrkit::vulkan
