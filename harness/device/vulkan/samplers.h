// The few samplers there are, made when first asked for.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "base/error.h"
#include "device/device.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"

namespace ssrkit::vulkan {

class Samplers {
 public:
  explicit Samplers(std::shared_ptr<const Gpu> gpu) : gpu_(std::move(gpu)) {}

  [[nodiscard]] Expected<VkSampler> get(const SampledImage& sampled);

 private:
  static constexpr std::size_t kFilterCount = 2;
  static constexpr std::size_t kAddressCount = 3;

  std::shared_ptr<const Gpu> gpu_;
  std::array<Handle<VkSampler>, kFilterCount * kAddressCount * kAddressCount> samplers_;
};

}  // namespace ssrkit::vulkan
