// A pass as Vulkan commands.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "device/vulkan/functions.h"
#include "device/vulkan/memory.h"
#include "device/vulkan/program.h"

namespace ssrkit::vulkan {

// Vertices in host-visible memory.
class VulkanBuffer final : public DeviceBuffer {
 public:
  [[nodiscard]] static Expected<std::unique_ptr<VulkanBuffer>> create(const std::shared_ptr<const Gpu>& gpu,
                                                                      std::span<const std::byte> bytes);
  [[nodiscard]] VkBuffer get() const { return buffer_.buffer.get(); }
  [[nodiscard]] std::size_t byteCount() const { return buffer_.size_bytes; }

 private:
  VulkanBuffer(std::shared_ptr<const Gpu> gpu, MappedBuffer buffer)
      : gpu_(std::move(gpu)), buffer_(std::move(buffer)) {}

  std::shared_ptr<const Gpu> gpu_;
  MappedBuffer buffer_;
};

// The views of a pass's attachments; those of the colours first, in their order.
[[nodiscard]] Expected<std::vector<VkImageView>> attachmentViews(const PassDesc& pass);

// Records the barriers and the draws of a pass that checkPass has passed, with one descriptor set a draw.
// Clears are of the whole mip, whatever the viewport.
void recordPass(const DeviceFunctions& functions, VkCommandBuffer commands, const PassDesc& pass,
                const VulkanProgram& program, std::span<const VkImageView> views,
                std::span<const VkDescriptorSet> sets);

}  // namespace ssrkit::vulkan
