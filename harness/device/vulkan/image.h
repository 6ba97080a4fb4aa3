// An image in optimal tiling, its views, and the layout that each of its mips is in.
#pragma once

#include <memory>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"

namespace ssrkit::vulkan {

class VulkanImage final : public DeviceImage {
 public:
  [[nodiscard]] static Expected<std::unique_ptr<VulkanImage>> create(const std::shared_ptr<const Gpu>& gpu,
                                                                     const ImageDesc& desc);

  [[nodiscard]] const ImageDesc& desc() const override { return desc_; }
  [[nodiscard]] VkImage get() const { return image_.get(); }
  [[nodiscard]] VkImageAspectFlags aspect() const;
  [[nodiscard]] bool canFilterLinearly() const { return can_filter_linearly_; }

  // A view of these mips; made once and kept.
  [[nodiscard]] Expected<VkImageView> view(int base_mip, int mip_count) const;

  // Where a mip's texels are now. Not part of the image's value, so a const image has a layout that changes.
  [[nodiscard]] VkImageLayout& layout(int mip) const { return layouts_[static_cast<std::size_t>(mip)]; }

 private:
  struct CachedView {
    int base_mip;
    int mip_count;
    Handle<VkImageView> view;
  };

  VulkanImage(std::shared_ptr<const Gpu> gpu, ImageDesc desc);
  [[nodiscard]] Expected<void> createImage(const std::string& attempted);

  std::shared_ptr<const Gpu> gpu_;
  ImageDesc desc_;
  bool can_filter_linearly_ = false;
  Handle<VkDeviceMemory> memory_;
  Handle<VkImage> image_;
  mutable std::vector<CachedView> views_;
  mutable std::vector<VkImageLayout> layouts_;
};

[[nodiscard]] VkFormat vulkanFormat(Format format);

}  // namespace ssrkit::vulkan
