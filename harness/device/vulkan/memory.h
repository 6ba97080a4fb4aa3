// Memory of images, and buffers that stay mapped.
#pragma once

#include <cstddef>
#include <string_view>

#include "base/error.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"

namespace ssrkit::vulkan {

// Memory that satisfies `requirements` and has all of `required`; the type with most of `wished` is taken.
// Fails (kSetup) when no type fits, when it is larger than its heap, and on the driver's own word.
[[nodiscard]] Expected<Handle<VkDeviceMemory>> allocateMemory(const Gpu& gpu,
                                                              const VkMemoryRequirements& requirements,
                                                              VkMemoryPropertyFlags required,
                                                              VkMemoryPropertyFlags wished,
                                                              std::string_view attempted);

// A buffer in coherent host memory, mapped as long as it lives.
struct MappedBuffer {
  Handle<VkDeviceMemory> memory;  // before the buffer: it must go after it
  Handle<VkBuffer> buffer;
  std::byte* data = nullptr;
  std::size_t size_bytes = 0;
};

// `wished` as above: VK_MEMORY_PROPERTY_HOST_CACHED_BIT where the host reads, DEVICE_LOCAL where the device
// does.
[[nodiscard]] Expected<MappedBuffer> createMappedBuffer(const Gpu& gpu, std::size_t size_bytes,
                                                        VkBufferUsageFlags usage,
                                                        VkMemoryPropertyFlags wished,
                                                        std::string_view attempted);

}  // namespace ssrkit::vulkan
