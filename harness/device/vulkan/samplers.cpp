#include "device/vulkan/samplers.h"

namespace ssrkit::vulkan {

namespace {

VkSamplerAddressMode vulkanAddress(AddressMode mode) {
  switch (mode) {
    case AddressMode::kRepeat:
      return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case AddressMode::kMirror:
      return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case AddressMode::kClamp:
      break;
  }
  return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

VkSamplerCreateInfo samplerInfo(const SampledImage& sampled) {
  const bool linear = sampled.filter == Filter::kLinear;
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.minFilter = info.magFilter;
  info.mipmapMode = linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = vulkanAddress(sampled.address_u);
  info.addressModeV = vulkanAddress(sampled.address_v);
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.maxLod = VK_LOD_CLAMP_NONE;
  return info;
}

}  // namespace

Expected<VkSampler> Samplers::get(const SampledImage& sampled) {
  const std::size_t index = (static_cast<std::size_t>(sampled.filter) * kAddressCount +
                             static_cast<std::size_t>(sampled.address_u)) *
                                kAddressCount +
                            static_cast<std::size_t>(sampled.address_v);
  Handle<VkSampler>& sampler = samplers_.at(index);
  if (sampler.get() == VK_NULL_HANDLE) {
    auto made = makeHandle(gpu_->get(), "vkCreateSampler", gpu_->functions().vkCreateSampler,
                           gpu_->functions().vkDestroySampler, samplerInfo(sampled), "make a sampler");
    if (!made) {
      return passOn(made);
    }
    sampler = std::move(*made);
  }
  return sampler.get();
}

}  // namespace ssrkit::vulkan
