// A pipeline with the one descriptor set that its shaders read.
#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "device/pass_rules.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"

namespace ssrkit::vulkan {

class VulkanProgram final : public DeviceProgram {
 public:
  // Fails (kInput) on SPIR-V that is not valid, (kSetup) when the driver refuses it; the reasons hold what
  // the validation layer said.
  [[nodiscard]] static Expected<std::unique_ptr<VulkanProgram>> create(const std::shared_ptr<const Gpu>& gpu,
                                                                       const ProgramDesc& desc);

  [[nodiscard]] const ProgramLayout& layout() const { return layout_; }
  [[nodiscard]] VkPipeline pipeline() const { return pipeline_.get(); }
  [[nodiscard]] VkPipelineLayout pipelineLayout() const { return pipeline_layout_.get(); }
  [[nodiscard]] VkDescriptorSetLayout setLayout() const { return set_layout_.get(); }

 private:
  VulkanProgram(std::shared_ptr<const Gpu> gpu, const ProgramDesc& desc);
  [[nodiscard]] Expected<void> createLayouts(const std::string& attempted);
  [[nodiscard]] Expected<void> createPipeline(const ProgramDesc& desc, const std::string& attempted);

  std::shared_ptr<const Gpu> gpu_;
  ProgramLayout layout_;
  Handle<VkDescriptorSetLayout> set_layout_;
  Handle<VkPipelineLayout> pipeline_layout_;
  Handle<VkPipeline> pipeline_;
};

}  // namespace ssrkit::vulkan
