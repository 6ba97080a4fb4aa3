// One command buffer, recorded, submitted and waited for again and again.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "device/device.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"

namespace ssrkit::vulkan {

class Commands {
 public:
  [[nodiscard]] static Expected<Commands> create(const std::shared_ptr<const Gpu>& gpu);

  // An empty command buffer that records. `attempted` is for the error.
  [[nodiscard]] Expected<VkCommandBuffer> begin(std::string_view attempted);

  // Brackets what PassTime::device_ns measures; without timestamps on the device they do nothing.
  void startTimer();
  void stopTimer();

  // Ends the recording, submits it and waits until it is done. The time is that of submit and wait alone.
  [[nodiscard]] Expected<PassTime> submitAndWait(std::string_view attempted);

 private:
  explicit Commands(std::shared_ptr<const Gpu> gpu) : gpu_(std::move(gpu)) {}
  [[nodiscard]] Expected<void> createPool();
  [[nodiscard]] Expected<void> createTimer();
  [[nodiscard]] std::optional<std::int64_t> timerNs() const;

  std::shared_ptr<const Gpu> gpu_;
  Handle<VkCommandPool> pool_;
  Handle<VkFence> fence_;
  Handle<VkQueryPool> timer_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  bool timer_used_ = false;
};

}  // namespace ssrkit::vulkan
