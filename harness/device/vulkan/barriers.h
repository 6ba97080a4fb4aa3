// Layout transitions and memory dependencies of one batch of work.
#pragma once

#include <vector>

#include "device/vulkan/functions.h"
#include "device/vulkan/image.h"

namespace ssrkit::vulkan {

// The kit uses each layout for one purpose only, so a mip's layout also says which stages touched it last and
// how: no other state is needed to make the dependency exact.
class Barriers {
 public:
  // The mips will next be used in `layout`. Nothing is added where they are only read, before and after.
  void use(const VulkanImage& image, int base_mip, int mip_count, VkImageLayout layout);

  // Records all of them as one command.
  void record(const DeviceFunctions& functions, VkCommandBuffer commands);

 private:
  void add(const VulkanImage& image, int mip, VkImageLayout layout);
  void forgetWhatTheyWaitFor();

  std::vector<VkImageMemoryBarrier2> barriers_;
};

}  // namespace ssrkit::vulkan
