#include "device/vulkan/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "device/spirv_check.h"
#include "device/vulkan/module_rules.h"
#include "device/vulkan/pipeline.h"

namespace ssrkit::vulkan {

namespace {

constexpr VkShaderStageFlags kStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

Expected<void> checkLimits(const ProgramDesc& desc, const VkPhysicalDeviceLimits& limits,
                           const std::string& attempted) {
  if (desc.sampler_bindings.size() > limits.maxPerStageDescriptorSamplers) {
    return inputError(attempted,
                      fmt::format("it reads {} images and the device allows {}", desc.sampler_bindings.size(),
                                  limits.maxPerStageDescriptorSamplers));
  }
  if (desc.colour_formats.size() > limits.maxColorAttachments) {
    return inputError(attempted, fmt::format("it draws to {} images and the device allows {}",
                                             desc.colour_formats.size(), limits.maxColorAttachments));
  }
  return {};
}

Expected<void> checkModules(const ProgramDesc& desc, const VkPhysicalDeviceLimits& limits,
                            const std::string& attempted) {
  Expected<void> valid = checkSpirv(desc.name, "vertex", desc.vertex_spirv, SpirvEnvironment::kVulkan11);
  if (valid) {
    valid = checkModule(desc.vertex_spirv, VK_SHADER_STAGE_VERTEX_BIT, limits, attempted);
  }
  if (valid) {
    valid = checkSpirv(desc.name, "fragment", desc.fragment_spirv, SpirvEnvironment::kVulkan11);
  }
  if (valid) {
    valid = checkModule(desc.fragment_spirv, VK_SHADER_STAGE_FRAGMENT_BIT, limits, attempted);
  }
  return valid;
}

}  // namespace

VulkanProgram::VulkanProgram(std::shared_ptr<const Gpu> gpu, const ProgramDesc& desc)
    : gpu_(std::move(gpu)), layout_(layoutOf(desc)) {}

Expected<std::unique_ptr<VulkanProgram>> VulkanProgram::create(const std::shared_ptr<const Gpu>& gpu,
                                                               const ProgramDesc& desc) {
  const std::string attempted = fmt::format("make the program '{}'", desc.name);
  Expected<void> done = checkLimits(desc, gpu->physical().limits, attempted);
  if (done) {
    done = checkModules(desc, gpu->physical().limits, attempted);
  }
  std::unique_ptr<VulkanProgram> program(new VulkanProgram(gpu, desc));
  if (done) {
    done = program->createLayouts(attempted);
  }
  if (done) {
    done = program->createPipeline(desc, attempted);
  }
  if (!done) {
    Error error = std::move(done.error());
    std::ranges::move(gpu->instance().messages().drain(), std::back_inserter(error.reasons));
    return tl::make_unexpected(std::move(error));
  }
  return program;
}

Expected<void> VulkanProgram::createLayouts(const std::string& attempted) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const std::uint32_t binding : layout_.sampler_bindings) {
    bindings.push_back({binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, kStages, nullptr});
  }
  for (const std::uint32_t binding : layout_.uniform_bindings) {
    bindings.push_back({binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, kStages, nullptr});
  }
  VkDescriptorSetLayoutCreateInfo set_info{};
  set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  set_info.pBindings = bindings.data();
  const DeviceFunctions& functions = gpu_->functions();
  auto set_layout =
      makeHandle(gpu_->get(), "vkCreateDescriptorSetLayout", functions.vkCreateDescriptorSetLayout,
                 functions.vkDestroyDescriptorSetLayout, set_info, attempted);
  if (!set_layout) {
    return passOn(set_layout);
  }
  set_layout_ = std::move(*set_layout);

  const VkDescriptorSetLayout set = set_layout_.get();
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  auto pipeline_layout = makeHandle(gpu_->get(), "vkCreatePipelineLayout", functions.vkCreatePipelineLayout,
                                    functions.vkDestroyPipelineLayout, info, attempted);
  if (!pipeline_layout) {
    return passOn(pipeline_layout);
  }
  pipeline_layout_ = std::move(*pipeline_layout);
  return {};
}

Expected<void> VulkanProgram::createPipeline(const ProgramDesc& desc, const std::string& attempted) {
  auto pipeline = makePipeline(*gpu_, desc, pipeline_layout_.get(), attempted);
  if (!pipeline) {
    return passOn(pipeline);
  }
  pipeline_ = std::move(*pipeline);
  gpu_->nameObject(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline_.get()), desc.name);
  return {};
}

}  // namespace ssrkit::vulkan
