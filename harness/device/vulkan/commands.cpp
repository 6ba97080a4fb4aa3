#include "device/vulkan/commands.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "device/pass_clock.h"

namespace ssrkit::vulkan {

namespace {

constexpr std::string_view kAttemptedCommandBuffer = "prepare the Vulkan command buffer";

}  // namespace

Expected<Commands> Commands::create(const std::shared_ptr<const Gpu>& gpu) {
  Commands commands(gpu);
  Expected<void> done = commands.createPool();
  if (done) {
    done = commands.createTimer();
  }
  if (!done) {
    return passOn(done);
  }
  return commands;
}

Expected<void> Commands::createPool() {
  const DeviceFunctions& functions = gpu_->functions();
  VkCommandPoolCreateInfo pool_info{};
  pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool_info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool_info.queueFamilyIndex = gpu_->physical().queue_family;
  auto pool = makeHandle(gpu_->get(), "vkCreateCommandPool", functions.vkCreateCommandPool,
                         functions.vkDestroyCommandPool, pool_info, kAttemptedCommandBuffer);
  if (!pool) {
    return passOn(pool);
  }
  VkFenceCreateInfo fence_info{};
  fence_info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  auto fence = makeHandle(gpu_->get(), "vkCreateFence", functions.vkCreateFence, functions.vkDestroyFence,
                          fence_info, kAttemptedCommandBuffer);
  if (!fence) {
    return passOn(fence);
  }
  pool_ = std::move(*pool);
  fence_ = std::move(*fence);
  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = pool_.get();
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  const VkResult result = functions.vkAllocateCommandBuffers(gpu_->get(), &info, &commands_);
  if (result != VK_SUCCESS) {
    return resultError(std::string(kAttemptedCommandBuffer), "vkAllocateCommandBuffers", result);
  }
  return {};
}

Expected<void> Commands::createTimer() {
  if (gpu_->physical().timestamp_valid_bits == 0) {
    return {};
  }
  VkQueryPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = 2;
  auto timer = makeHandle(gpu_->get(), "vkCreateQueryPool", gpu_->functions().vkCreateQueryPool,
                          gpu_->functions().vkDestroyQueryPool, info, kAttemptedCommandBuffer);
  if (!timer) {
    return passOn(timer);
  }
  timer_ = std::move(*timer);
  return {};
}

Expected<VkCommandBuffer> Commands::begin(std::string_view attempted) {
  timer_used_ = false;
  VkResult result = gpu_->functions().vkResetCommandPool(gpu_->get(), pool_.get(), 0);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkResetCommandPool", result);
  }
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  result = gpu_->functions().vkBeginCommandBuffer(commands_, &info);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkBeginCommandBuffer", result);
  }
  return commands_;
}

void Commands::startTimer() {
  if (timer_.get() == VK_NULL_HANDLE) {
    return;
  }
  gpu_->functions().vkCmdResetQueryPool(commands_, timer_.get(), 0, 2);
  gpu_->functions().vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_TOP_OF_PIPE_BIT, timer_.get(), 0);
}

void Commands::stopTimer() {
  if (timer_.get() == VK_NULL_HANDLE) {
    return;
  }
  gpu_->functions().vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, timer_.get(), 1);
  timer_used_ = true;
}

Expected<PassTime> Commands::submitAndWait(std::string_view attempted) {
  const DeviceFunctions& functions = gpu_->functions();
  VkResult result = functions.vkEndCommandBuffer(commands_);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkEndCommandBuffer", result);
  }
  VkCommandBufferSubmitInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
  buffer.commandBuffer = commands_;
  VkSubmitInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &buffer;
  const VkFence fence = fence_.get();

  const PassClock clock;
  result = functions.vkQueueSubmit2(gpu_->queue(), 1, &info, fence);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkQueueSubmit2", result);
  }
  result =
      functions.vkWaitForFences(gpu_->get(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
  PassTime time = clock.elapsed();
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkWaitForFences", result);
  }
  result = functions.vkResetFences(gpu_->get(), 1, &fence);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkResetFences", result);
  }
  time.device_ns = timerNs();
  return time;
}

std::optional<std::int64_t> Commands::timerNs() const {
  if (!timer_used_) {
    return std::nullopt;
  }
  std::array<std::uint64_t, 2> ticks{};
  const VkResult result = gpu_->functions().vkGetQueryPoolResults(
      gpu_->get(), timer_.get(), 0, 2, sizeof(ticks), ticks.data(), sizeof(ticks[0]), VK_QUERY_RESULT_64_BIT);
  if (result != VK_SUCCESS) {
    return std::nullopt;
  }
  const std::uint32_t bits = gpu_->physical().timestamp_valid_bits;
  const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  const auto elapsed = static_cast<double>((ticks[1] - ticks[0]) & mask);
  return std::llround(elapsed * static_cast<double>(gpu_->physical().limits.timestampPeriod));
}

}  // namespace ssrkit::vulkan
