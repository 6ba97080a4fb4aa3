#include "device/vulkan/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "device/format.h"
#include "device/pass_rules.h"
#include "device/vulkan/memory.h"

namespace ssrkit::vulkan {

namespace {

VkImageUsageFlags usageOf(Format format) {
  return VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
         (format == Format::kD32f ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                  : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
}

VkImageCreateInfo imageCreateInfo(const ImageDesc& desc) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = vulkanFormat(desc.format);
  info.extent = {static_cast<std::uint32_t>(desc.size.width), static_cast<std::uint32_t>(desc.size.height),
                 1};
  info.mipLevels = static_cast<std::uint32_t>(desc.mip_count);
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = usageOf(desc.format);
  info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  return info;
}

// Asked before the image is made: a driver that is asked for too much may crash instead of refusing.
Expected<void> checkSupport(const Gpu& gpu, const ImageDesc& desc, const std::string& attempted) {
  const VkImageCreateInfo info = imageCreateInfo(desc);
  VkImageFormatProperties limits;
  const VkResult result = gpu.instance().functions().vkGetPhysicalDeviceImageFormatProperties(
      gpu.physical().handle, info.format, info.imageType, info.tiling, info.usage, info.flags, &limits);
  if (result != VK_SUCCESS) {
    return resultError(attempted, "vkGetPhysicalDeviceImageFormatProperties", result);
  }
  const VkDeviceSize bytes =
      VkDeviceSize{formatInfo(desc.format).bytes_per_texel} * info.extent.width * info.extent.height;
  if (bytes > limits.maxResourceSize) {
    return setupError(attempted,
                      fmt::format("{}: its {} bytes are more than the device's limit of {}",
                                  resultName(VK_ERROR_OUT_OF_DEVICE_MEMORY), bytes, limits.maxResourceSize),
                      {}, "use a smaller image size");
  }
  return {};
}

// Every image may be drawn to; SwiftShader samples images of 16384 texels and draws to 8192.
int longestSide(const VkPhysicalDeviceLimits& limits) {
  return static_cast<int>(
      std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight}));
}

}  // namespace

VkFormat vulkanFormat(Format format) {
  switch (format) {
    case Format::kR8ui:
      return VK_FORMAT_R8_UINT;
    case Format::kRgba8:
      return VK_FORMAT_R8G8B8A8_UNORM;
    case Format::kRgba8Srgb:
      return VK_FORMAT_R8G8B8A8_SRGB;
    case Format::kRg16i:
      return VK_FORMAT_R16G16_SINT;
    case Format::kRgba16ui:
      return VK_FORMAT_R16G16B16A16_UINT;
    case Format::kRgba16f:
      return VK_FORMAT_R16G16B16A16_SFLOAT;
    case Format::kR32f:
      return VK_FORMAT_R32_SFLOAT;
    case Format::kRg32f:
      return VK_FORMAT_R32G32_SFLOAT;
    case Format::kRgba32f:
      return VK_FORMAT_R32G32B32A32_SFLOAT;
    case Format::kD32f:
      return VK_FORMAT_D32_SFLOAT;
  }
  return VK_FORMAT_UNDEFINED;
}

VulkanImage::VulkanImage(std::shared_ptr<const Gpu> gpu, ImageDesc desc)
    : gpu_(std::move(gpu)),
      desc_(std::move(desc)),
      layouts_(static_cast<std::size_t>(desc_.mip_count), VK_IMAGE_LAYOUT_UNDEFINED) {}

Expected<std::unique_ptr<VulkanImage>> VulkanImage::create(const std::shared_ptr<const Gpu>& gpu,
                                                           const ImageDesc& desc) {
  Expected<void> done = checkImageDesc(desc, longestSide(gpu->physical().limits));
  if (!done) {
    return passOn(done);
  }
  const std::string attempted = fmt::format("create the image '{}' of {} x {} texels in {}", desc.name,
                                            desc.size.width, desc.size.height, formatName(desc.format));
  done = checkSupport(*gpu, desc, attempted);
  std::unique_ptr<VulkanImage> image(new VulkanImage(gpu, desc));
  if (done) {
    done = image->createImage(attempted);
  }
  if (!done) {
    return passOn(done);
  }
  return image;
}

Expected<void> VulkanImage::createImage(const std::string& attempted) {
  const DeviceFunctions& functions = gpu_->functions();
  auto image = makeHandle(gpu_->get(), "vkCreateImage", functions.vkCreateImage, functions.vkDestroyImage,
                          imageCreateInfo(desc_), attempted);
  if (!image) {
    return passOn(image);
  }
  VkMemoryRequirements requirements;
  functions.vkGetImageMemoryRequirements(gpu_->get(), image->get(), &requirements);
  auto memory = allocateMemory(*gpu_, requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, attempted);
  if (!memory) {
    return passOn(memory);
  }
  const VkResult result = functions.vkBindImageMemory(gpu_->get(), image->get(), memory->get(), 0);
  if (result != VK_SUCCESS) {
    return resultError(attempted, "vkBindImageMemory", result);
  }
  memory_ = std::move(*memory);
  image_ = std::move(*image);
  gpu_->nameObject(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image_.get()), desc_.name);

  VkFormatProperties properties;
  gpu_->instance().functions().vkGetPhysicalDeviceFormatProperties(gpu_->physical().handle,
                                                                   vulkanFormat(desc_.format), &properties);
  can_filter_linearly_ =
      (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
  return {};
}

VkImageAspectFlags VulkanImage::aspect() const {
  return desc_.format == Format::kD32f ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

Expected<VkImageView> VulkanImage::view(int base_mip, int mip_count) const {
  for (const CachedView& cached : views_) {
    if (cached.base_mip == base_mip && cached.mip_count == mip_count) {
      return cached.view.get();
    }
  }
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image_.get();
  info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  info.format = vulkanFormat(desc_.format);
  info.subresourceRange = {aspect(), static_cast<std::uint32_t>(base_mip),
                           static_cast<std::uint32_t>(mip_count), 0, 1};
  auto view =
      makeHandle(gpu_->get(), "vkCreateImageView", gpu_->functions().vkCreateImageView,
                 gpu_->functions().vkDestroyImageView, info, fmt::format("view the image '{}'", desc_.name));
  if (!view) {
    return passOn(view);
  }
  views_.push_back({base_mip, mip_count, std::move(*view)});
  return views_.back().view.get();
}

}  // namespace ssrkit::vulkan
