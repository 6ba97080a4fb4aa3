#include "device/vulkan/barriers.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/check.h"

namespace ssrkit::vulkan {

namespace {

struct Use {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
  bool writes;
};

Use useOf(VkImageLayout layout) {
  switch (layout) {
    case VK_IMAGE_LAYOUT_UNDEFINED:
      return {VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, false};
    case VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL:
      return {VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
              VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, false};
    case VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL:
      return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, true};
    case VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL:
      return {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
              true};
    case VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL:
      return {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, false};
    default:
      SSRKIT_CHECK_EQ(static_cast<int>(layout), static_cast<int>(VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL));
      return {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, true};
  }
}

bool isFaultAskedFor() {
  const char* const fault = std::getenv("SSRKIT_FAULT");
  return fault != nullptr && std::string_view(fault) == "barrier:";
}

}  // namespace

void Barriers::use(const VulkanImage& image, int base_mip, int mip_count, VkImageLayout layout) {
  for (int mip = base_mip; mip < base_mip + mip_count; ++mip) {
    if (image.layout(mip) != layout || useOf(layout).writes) {
      add(image, mip, layout);
    }
  }
}

void Barriers::add(const VulkanImage& image, int mip, VkImageLayout layout) {
  const Use before = useOf(image.layout(mip));
  const Use after = useOf(layout);
  VkImageMemoryBarrier2 barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  barrier.srcStageMask = before.stages;
  barrier.srcAccessMask = before.writes ? before.access : VK_ACCESS_2_NONE;
  barrier.dstStageMask = after.stages;
  barrier.dstAccessMask = after.access;
  barrier.oldLayout = image.layout(mip);
  barrier.newLayout = layout;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.get();
  barrier.subresourceRange = {image.aspect(), static_cast<std::uint32_t>(mip), 1, 0, 1};
  barriers_.push_back(barrier);
  image.layout(mip) = layout;
}

// A hook for tests of the validation pass: transitions that wait for nothing and hold nothing back.
void Barriers::forgetWhatTheyWaitFor() {
  for (VkImageMemoryBarrier2& barrier : barriers_) {
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_NONE;
    barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_2_NONE;
  }
}

void Barriers::record(const DeviceFunctions& functions, VkCommandBuffer commands) {
  if (barriers_.empty()) {
    return;
  }
  static const bool is_faulty = isFaultAskedFor();
  if (is_faulty) {
    forgetWhatTheyWaitFor();
  }
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.imageMemoryBarrierCount = static_cast<std::uint32_t>(barriers_.size());
  info.pImageMemoryBarriers = barriers_.data();
  functions.vkCmdPipelineBarrier2(commands, &info);
  barriers_.clear();
}

}  // namespace ssrkit::vulkan
