#include "device/vulkan/transfer.h"

#include <cstdint>
#include <cstring>
#include <utility>

#include "base/check.h"
#include "device/format.h"
#include "device/pass_rules.h"
#include "device/vulkan/barriers.h"

namespace ssrkit::vulkan {

namespace {

VkExtent3D mipExtent(const VulkanImage& image, int mip) {
  const Size size = mipSize(image.desc(), mip);
  return {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height), 1};
}

VkImageSubresourceLayers mipLayers(const VulkanImage& image, int mip) {
  return {image.aspect(), static_cast<std::uint32_t>(mip), 0, 1};
}

// The whole mip as tightly packed rows at the buffer's start.
VkBufferImageCopy wholeMip(const VulkanImage& image, int mip) {
  VkBufferImageCopy region{};
  region.imageSubresource = mipLayers(image, mip);
  region.imageExtent = mipExtent(image, mip);
  return region;
}

// Makes what the device wrote to the buffer visible to the host once the fence has been waited for.
void recordHostRead(const DeviceFunctions& functions, VkCommandBuffer commands, VkBuffer buffer) {
  VkBufferMemoryBarrier2 barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2;
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.buffer = buffer;
  barrier.size = VK_WHOLE_SIZE;
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.bufferMemoryBarrierCount = 1;
  info.pBufferMemoryBarriers = &barrier;
  functions.vkCmdPipelineBarrier2(commands, &info);
}

Expected<void> finish(Commands& commands, std::string_view attempted) {
  const auto time = commands.submitAndWait(attempted);
  if (!time) {
    return tl::make_unexpected(time.error());
  }
  return {};
}

}  // namespace

Expected<void> Transfer::growStaging(std::size_t size_bytes) {
  if (size_bytes <= staging_.size_bytes) {
    return {};
  }
  staging_ = {};  // first, so that the old and the new one need not fit together
  constexpr std::size_t kGranularity = std::size_t{1} << 20;
  const std::size_t rounded = (size_bytes + kGranularity - 1) / kGranularity * kGranularity;
  auto buffer =
      createMappedBuffer(*gpu_, rounded, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                         VK_MEMORY_PROPERTY_HOST_CACHED_BIT, "make a staging buffer");
  if (!buffer) {
    return passOn(buffer);
  }
  staging_ = std::move(*buffer);
  return {};
}

Expected<void> Transfer::upload(Commands& commands, const VulkanImage& image, int mip,
                                std::span<const std::byte> bytes) {
  constexpr std::string_view kAttempted = "upload an image";
  checkUpload(image.desc(), mip, bytes);
  Expected<void> grown = growStaging(bytes.size());
  if (!grown) {
    return grown;
  }
  std::memcpy(staging_.data, bytes.data(), bytes.size());
  auto buffer = commands.begin(kAttempted);
  if (!buffer) {
    return passOn(buffer);
  }
  Barriers barriers;
  barriers.use(image, mip, 1, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  barriers.record(gpu_->functions(), *buffer);
  const VkBufferImageCopy region = wholeMip(image, mip);
  gpu_->functions().vkCmdCopyBufferToImage(*buffer, staging_.buffer.get(), image.get(),
                                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  return finish(commands, kAttempted);
}

Expected<std::vector<std::byte>> Transfer::read(Commands& commands, const VulkanImage& image, int mip) {
  constexpr std::string_view kAttempted = "read an image back";
  const std::size_t byte_count = mipByteCount(image.desc(), mip);
  Expected<void> done = growStaging(byte_count);
  if (!done) {
    return passOn(done);
  }
  auto buffer = commands.begin(kAttempted);
  if (!buffer) {
    return passOn(buffer);
  }
  Barriers barriers;
  barriers.use(image, mip, 1, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  barriers.record(gpu_->functions(), *buffer);
  const VkBufferImageCopy region = wholeMip(image, mip);
  gpu_->functions().vkCmdCopyImageToBuffer(*buffer, image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                           staging_.buffer.get(), 1, &region);
  recordHostRead(gpu_->functions(), *buffer, staging_.buffer.get());
  done = finish(commands, kAttempted);
  if (!done) {
    return passOn(done);
  }
  return std::vector<std::byte>(staging_.data, staging_.data + byte_count);
}

Expected<void> Transfer::copy(Commands& commands, const VulkanImage& from, int mip, Size size,
                              const VulkanImage& to, int x, int y) {
  constexpr std::string_view kAttempted = "copy an image";
  checkCopy(from.desc(), mip, size, to.desc(), x, y);
  SSRKIT_CHECK(&from != &to || mip != 0);
  auto buffer = commands.begin(kAttempted);
  if (!buffer) {
    return passOn(buffer);
  }
  Barriers barriers;
  barriers.use(from, mip, 1, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  barriers.use(to, 0, 1, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  barriers.record(gpu_->functions(), *buffer);
  VkImageCopy region{};
  region.srcSubresource = mipLayers(from, mip);
  region.dstSubresource = mipLayers(to, 0);
  region.dstOffset = {x, y, 0};
  region.extent = {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height), 1};
  gpu_->functions().vkCmdCopyImage(*buffer, from.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.get(),
                                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  return finish(commands, kAttempted);
}

}  // namespace ssrkit::vulkan
