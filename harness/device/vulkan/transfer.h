// Texels between the host and images, and between images.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "device/vulkan/commands.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/image.h"
#include "device/vulkan/memory.h"

namespace ssrkit::vulkan {

// Keeps one staging buffer, which grows to the largest mip that went through it.
class Transfer {
 public:
  explicit Transfer(std::shared_ptr<const Gpu> gpu) : gpu_(std::move(gpu)) {}

  // Tightly packed rows, row 0 on top; the span's size is the mip's.
  [[nodiscard]] Expected<void> upload(Commands& commands, const VulkanImage& image, int mip,
                                      std::span<const std::byte> bytes);
  [[nodiscard]] Expected<std::vector<std::byte>> read(Commands& commands, const VulkanImage& image, int mip);

  // The upper left `size` texels of the mip of `from` to mip 0 of `to`, their corner at (x, y).
  [[nodiscard]] Expected<void> copy(Commands& commands, const VulkanImage& from, int mip, Size size,
                                    const VulkanImage& to, int x, int y);

 private:
  [[nodiscard]] Expected<void> growStaging(std::size_t size_bytes);

  std::shared_ptr<const Gpu> gpu_;
  MappedBuffer staging_;
};

}  // namespace ssrkit::vulkan
