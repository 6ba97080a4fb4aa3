#include "device/vulkan/descriptors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "device/vulkan/image.h"

namespace ssrkit::vulkan {

namespace {

constexpr std::string_view kAttemptedBinding = "bind the images of a pass";

const SampledImage* findBinding(std::span<const SampledImage> sampled, std::uint32_t binding) {
  const auto found = std::ranges::find(sampled, binding, &SampledImage::binding);
  return found == sampled.end() ? nullptr : &*found;
}

VkWriteDescriptorSet emptyWrite(VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type) {
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = type;
  return write;
}

Expected<VkDescriptorImageInfo> sampledImageInfo(const SampledImage& sampled, Samplers& samplers) {
  const auto& image = static_cast<const VulkanImage&>(*sampled.image);
  if (sampled.filter == Filter::kLinear && !image.canFilterLinearly()) {
    return setupError(std::string(kAttemptedBinding),
                      fmt::format("the device cannot filter '{}' linearly in its format", image.desc().name));
  }
  const auto sampler = samplers.get(sampled);
  if (!sampler) {
    return tl::make_unexpected(sampler.error());
  }
  const auto view = image.view(sampled.base_mip, sampled.mip_count);
  if (!view) {
    return tl::make_unexpected(view.error());
  }
  return VkDescriptorImageInfo{*sampler, *view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

}  // namespace

const SampledImage* sampledAt(const PassDesc& pass, const DrawCall& draw, std::uint32_t binding) {
  const SampledImage* own = findBinding(draw.sampled, binding);
  return own != nullptr ? own : findBinding(pass.sampled, binding);
}

Expected<std::vector<VkDescriptorSet>> Descriptors::prepare(const PassDesc& pass,
                                                            const VulkanProgram& program) {
  const auto plain_draws = static_cast<std::size_t>(
      std::ranges::count_if(pass.draws, [](const DrawCall& draw) { return draw.sampled.empty(); }));
  if (pass.draws.empty()) {
    return std::vector<VkDescriptorSet>{};  // a pass that only clears
  }
  const std::size_t set_count = pass.draws.size() - plain_draws + (plain_draws > 0 ? 1 : 0);
  Expected<void> done = writeUniforms(pass.uniforms);
  if (done) {
    done = growPool(static_cast<std::uint32_t>(set_count), program.layout());
  }
  if (!done) {
    return passOn(done);
  }
  auto sets = allocate(static_cast<std::uint32_t>(set_count), program.setLayout());
  if (!sets) {
    return sets;
  }
  std::vector<VkDescriptorSet> set_of_draw;
  set_of_draw.reserve(pass.draws.size());
  VkDescriptorSet shared = VK_NULL_HANDLE;
  auto next = sets->begin();
  for (const DrawCall& draw : pass.draws) {
    if (draw.sampled.empty() && shared != VK_NULL_HANDLE) {
      set_of_draw.push_back(shared);
      continue;
    }
    const VkDescriptorSet set = *next++;
    done = write(set, pass, draw, program.layout());
    if (!done) {
      return passOn(done);
    }
    shared = draw.sampled.empty() ? set : shared;
    set_of_draw.push_back(set);
  }
  return set_of_draw;
}

Expected<void> Descriptors::writeUniforms(std::span<const std::byte> bytes) {
  uniform_bytes_used_ = bytes.size();
  if (bytes.empty()) {
    return {};
  }
  const std::uint32_t limit = gpu_->physical().limits.maxUniformBufferRange;
  if (bytes.size() > limit) {
    return setupError("fill the uniform block of a pass",
                      fmt::format("it has {} bytes and the device allows {}", bytes.size(), limit));
  }
  if (bytes.size() > uniforms_.size_bytes) {
    constexpr std::size_t kSmallest = 4096;
    auto buffer =
        createMappedBuffer(*gpu_, std::max(bytes.size(), kSmallest), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                           VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "make a uniform buffer");
    if (!buffer) {
      return passOn(buffer);
    }
    uniforms_ = std::move(*buffer);
  }
  std::memcpy(uniforms_.data, bytes.data(), bytes.size());
  return {};
}

Expected<void> Descriptors::growPool(std::uint32_t set_count, const ProgramLayout& layout) {
  const std::uint32_t images = set_count * static_cast<std::uint32_t>(layout.sampler_bindings.size());
  const std::uint32_t uniforms = set_count * static_cast<std::uint32_t>(layout.uniform_bindings.size());
  if (pool_.get() != VK_NULL_HANDLE && set_count <= set_capacity_ && images <= image_capacity_ &&
      uniforms <= uniform_capacity_) {
    const VkResult result = gpu_->functions().vkResetDescriptorPool(gpu_->get(), pool_.get(), 0);
    return result == VK_SUCCESS
               ? Expected<void>{}
               : resultError(std::string(kAttemptedBinding), "vkResetDescriptorPool", result);
  }
  set_capacity_ = std::max(set_count, set_capacity_);
  image_capacity_ = std::max({images, image_capacity_, 16U});
  uniform_capacity_ = std::max({uniforms, uniform_capacity_, 1U});
  const std::array sizes{VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, image_capacity_},
                         VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, uniform_capacity_}};
  VkDescriptorPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  info.maxSets = set_capacity_;
  info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  info.pPoolSizes = sizes.data();
  auto pool = makeHandle(gpu_->get(), "vkCreateDescriptorPool", gpu_->functions().vkCreateDescriptorPool,
                         gpu_->functions().vkDestroyDescriptorPool, info, kAttemptedBinding);
  if (!pool) {
    return passOn(pool);
  }
  pool_ = std::move(*pool);
  return {};
}

Expected<std::vector<VkDescriptorSet>> Descriptors::allocate(std::uint32_t set_count,
                                                             VkDescriptorSetLayout layout) {
  const std::vector<VkDescriptorSetLayout> layouts(set_count, layout);
  std::vector<VkDescriptorSet> sets(set_count, VK_NULL_HANDLE);
  VkDescriptorSetAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  info.descriptorPool = pool_.get();
  info.descriptorSetCount = set_count;
  info.pSetLayouts = layouts.data();
  const VkResult result = gpu_->functions().vkAllocateDescriptorSets(gpu_->get(), &info, sets.data());
  if (result != VK_SUCCESS) {
    return resultError(std::string(kAttemptedBinding), "vkAllocateDescriptorSets", result);
  }
  return sets;
}

Expected<void> Descriptors::write(VkDescriptorSet set, const PassDesc& pass, const DrawCall& draw,
                                  const ProgramLayout& layout) {
  std::vector<VkDescriptorImageInfo> images;
  images.reserve(layout.sampler_bindings.size());  // the writes point into it
  std::vector<VkWriteDescriptorSet> writes;
  for (const std::uint32_t binding : layout.sampler_bindings) {
    auto info = sampledImageInfo(*sampledAt(pass, draw, binding), samplers_);
    if (!info) {
      return passOn(info);
    }
    images.push_back(*info);
    writes.push_back(emptyWrite(set, binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER));
    writes.back().pImageInfo = &images.back();
  }
  const VkDescriptorBufferInfo uniforms{uniforms_.buffer.get(), 0, uniform_bytes_used_};
  for (const std::uint32_t binding : layout.uniform_bindings) {
    writes.push_back(emptyWrite(set, binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER));
    writes.back().pBufferInfo = &uniforms;
  }
  gpu_->functions().vkUpdateDescriptorSets(gpu_->get(), static_cast<std::uint32_t>(writes.size()),
                                           writes.data(), 0, nullptr);
  return {};
}

}  // namespace ssrkit::vulkan
