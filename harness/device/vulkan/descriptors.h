// The descriptor sets of one pass at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "device/vulkan/functions.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"
#include "device/vulkan/memory.h"
#include "device/vulkan/program.h"
#include "device/vulkan/samplers.h"

namespace ssrkit::vulkan {

// Keeps a descriptor pool and a uniform buffer, which grow to the largest pass. What `prepare` returns is
// good until it is called again: the pass before must be done by then.
class Descriptors {
 public:
  explicit Descriptors(const std::shared_ptr<const Gpu>& gpu) : gpu_(gpu), samplers_(gpu) {}

  // One set for each of the pass's draws, in their order; draws without images of their own share one. The
  // pass supplies what the program reads (checkPass).
  [[nodiscard]] Expected<std::vector<VkDescriptorSet>> prepare(const PassDesc& pass,
                                                               const VulkanProgram& program);

 private:
  [[nodiscard]] Expected<void> writeUniforms(std::span<const std::byte> bytes);
  [[nodiscard]] Expected<void> growPool(std::uint32_t set_count, const ProgramLayout& layout);
  [[nodiscard]] Expected<std::vector<VkDescriptorSet>> allocate(std::uint32_t set_count,
                                                                VkDescriptorSetLayout layout);
  [[nodiscard]] Expected<void> write(VkDescriptorSet set, const PassDesc& pass, const DrawCall& draw,
                                     const ProgramLayout& layout);

  std::shared_ptr<const Gpu> gpu_;
  Samplers samplers_;
  MappedBuffer uniforms_;
  std::size_t uniform_bytes_used_ = 0;
  Handle<VkDescriptorPool> pool_;
  std::uint32_t set_capacity_ = 0;
  std::uint32_t image_capacity_ = 0;
  std::uint32_t uniform_capacity_ = 0;
};

// The image that a draw sees at a binding: its own before the pass's; null when neither has one.
[[nodiscard]] const SampledImage* sampledAt(const PassDesc& pass, const DrawCall& draw,
                                            std::uint32_t binding);

}  // namespace ssrkit::vulkan
