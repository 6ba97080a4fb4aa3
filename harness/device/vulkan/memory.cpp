#include "device/vulkan/memory.h"

#include <fmt/format.h>

#include <bit>
#include <optional>
#include <string>
#include <utility>

namespace ssrkit::vulkan {

namespace {

std::optional<std::uint32_t> findMemoryType(const VkPhysicalDeviceMemoryProperties& memory,
                                            std::uint32_t allowed, VkMemoryPropertyFlags required,
                                            VkMemoryPropertyFlags wished) {
  std::optional<std::uint32_t> best;
  int best_score = -1;
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    const VkMemoryPropertyFlags flags = memory.memoryTypes[type].propertyFlags;
    const int score = std::popcount(flags & wished);
    if ((allowed & (1U << type)) != 0 && (flags & required) == required && score > best_score) {
      best = type;
      best_score = score;
    }
  }
  return best;
}

}  // namespace

Expected<Handle<VkDeviceMemory>> allocateMemory(const Gpu& gpu, const VkMemoryRequirements& requirements,
                                                VkMemoryPropertyFlags required, VkMemoryPropertyFlags wished,
                                                std::string_view attempted) {
  const VkPhysicalDeviceMemoryProperties& memory = gpu.physical().memory;
  const auto type = findMemoryType(memory, requirements.memoryTypeBits, required, wished);
  if (!type) {
    return setupError(std::string(attempted), "the device has no memory of the kind that it needs");
  }
  const VkDeviceSize heap_bytes = memory.memoryHeaps[memory.memoryTypes[*type].heapIndex].size;
  if (requirements.size > heap_bytes) {
    return setupError(std::string(attempted),
                      fmt::format("{}: it needs {} bytes and the device's heap has {}",
                                  resultName(VK_ERROR_OUT_OF_DEVICE_MEMORY), requirements.size, heap_bytes),
                      {}, "use a smaller image size");
  }
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = requirements.size;
  info.memoryTypeIndex = *type;
  return makeHandle(gpu.get(), "vkAllocateMemory", gpu.functions().vkAllocateMemory,
                    gpu.functions().vkFreeMemory, info, attempted);
}

Expected<MappedBuffer> createMappedBuffer(const Gpu& gpu, std::size_t size_bytes, VkBufferUsageFlags usage,
                                          VkMemoryPropertyFlags wished, std::string_view attempted) {
  const DeviceFunctions& functions = gpu.functions();
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = size_bytes;
  info.usage = usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  auto buffer = makeHandle(gpu.get(), "vkCreateBuffer", functions.vkCreateBuffer, functions.vkDestroyBuffer,
                           info, attempted);
  if (!buffer) {
    return passOn(buffer);
  }
  VkMemoryRequirements requirements;
  functions.vkGetBufferMemoryRequirements(gpu.get(), buffer->get(), &requirements);
  constexpr VkMemoryPropertyFlags kRequired =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  auto memory = allocateMemory(gpu, requirements, kRequired, wished, attempted);
  if (!memory) {
    return passOn(memory);
  }
  VkResult result = functions.vkBindBufferMemory(gpu.get(), buffer->get(), memory->get(), 0);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkBindBufferMemory", result);
  }
  void* data = nullptr;
  result = functions.vkMapMemory(gpu.get(), memory->get(), 0, VK_WHOLE_SIZE, 0, &data);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), "vkMapMemory", result);
  }
  return MappedBuffer{std::move(*memory), std::move(*buffer), static_cast<std::byte*>(data), size_bytes};
}

}  // namespace ssrkit::vulkan
