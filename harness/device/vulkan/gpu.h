// A logical device with its one queue: what every Vulkan object of the kit is made from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "device/vulkan/functions.h"
#include "device/vulkan/handle.h"
#include "device/vulkan/instance.h"
#include "device/vulkan/physical_device.h"

namespace ssrkit::vulkan {

// Shared by all that is made from it, so images, buffers and programs may outlive the Device that made them.
class Gpu {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<Gpu>> create(std::unique_ptr<Instance> instance,
                                                             PhysicalDevice physical);
  ~Gpu();
  Gpu(const Gpu&) = delete;
  Gpu& operator=(const Gpu&) = delete;

  [[nodiscard]] VkDevice get() const { return device_; }
  [[nodiscard]] VkQueue queue() const { return queue_; }
  [[nodiscard]] const DeviceFunctions& functions() const { return functions_; }
  [[nodiscard]] Instance& instance() const { return *instance_; }
  [[nodiscard]] const PhysicalDevice& physical() const { return physical_; }

  // Names the object in the messages of the validation layer; does nothing without one.
  void nameObject(VkObjectType type, std::uint64_t handle, const std::string& name) const;

 private:
  Gpu(std::unique_ptr<Instance> instance, PhysicalDevice physical);
  [[nodiscard]] Expected<void> createDevice();
  [[nodiscard]] Expected<void> loadFunctions();

  std::unique_ptr<Instance> instance_;
  PhysicalDevice physical_;
  DeviceFunctions functions_;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
};

}  // namespace ssrkit::vulkan
