// Every Vulkan function that the kit calls, named once. Tables of pointers are made from these lists; nothing
// is linked, so a machine without a Vulkan loader can still run the other devices.
#pragma once

#include <vulkan/vulkan_core.h>

#define SSRKIT_VULKAN_GLOBAL_FUNCTIONS(X) \
  X(vkCreateInstance)                     \
  X(vkEnumerateInstanceVersion)           \
  X(vkEnumerateInstanceLayerProperties)   \
  X(vkEnumerateInstanceExtensionProperties)

#define SSRKIT_VULKAN_INSTANCE_FUNCTIONS(X)   \
  X(vkDestroyInstance)                        \
  X(vkEnumeratePhysicalDevices)               \
  X(vkGetPhysicalDeviceProperties)            \
  X(vkGetPhysicalDeviceProperties2)           \
  X(vkGetPhysicalDeviceFeatures2)             \
  X(vkGetPhysicalDeviceQueueFamilyProperties) \
  X(vkGetPhysicalDeviceMemoryProperties)      \
  X(vkGetPhysicalDeviceFormatProperties)      \
  X(vkGetPhysicalDeviceImageFormatProperties) \
  X(vkCreateDevice)                           \
  X(vkGetDeviceProcAddr)

// Only there when VK_EXT_debug_utils was asked for.
#define SSRKIT_VULKAN_DEBUG_FUNCTIONS(X) \
  X(vkCreateDebugUtilsMessengerEXT)      \
  X(vkDestroyDebugUtilsMessengerEXT)     \
  X(vkSetDebugUtilsObjectNameEXT)

#define SSRKIT_VULKAN_DEVICE_FUNCTIONS(X) \
  X(vkDestroyDevice)                      \
  X(vkGetDeviceQueue)                     \
  X(vkDeviceWaitIdle)                     \
  X(vkAllocateMemory)                     \
  X(vkFreeMemory)                         \
  X(vkMapMemory)                          \
  X(vkCreateBuffer)                       \
  X(vkDestroyBuffer)                      \
  X(vkGetBufferMemoryRequirements)        \
  X(vkBindBufferMemory)                   \
  X(vkCreateImage)                        \
  X(vkDestroyImage)                       \
  X(vkGetImageMemoryRequirements)         \
  X(vkBindImageMemory)                    \
  X(vkCreateImageView)                    \
  X(vkDestroyImageView)                   \
  X(vkCreateSampler)                      \
  X(vkDestroySampler)                     \
  X(vkCreateShaderModule)                 \
  X(vkDestroyShaderModule)                \
  X(vkCreateDescriptorSetLayout)          \
  X(vkDestroyDescriptorSetLayout)         \
  X(vkCreatePipelineLayout)               \
  X(vkDestroyPipelineLayout)              \
  X(vkCreateGraphicsPipelines)            \
  X(vkDestroyPipeline)                    \
  X(vkCreateDescriptorPool)               \
  X(vkDestroyDescriptorPool)              \
  X(vkResetDescriptorPool)                \
  X(vkAllocateDescriptorSets)             \
  X(vkUpdateDescriptorSets)               \
  X(vkCreateCommandPool)                  \
  X(vkDestroyCommandPool)                 \
  X(vkResetCommandPool)                   \
  X(vkAllocateCommandBuffers)             \
  X(vkBeginCommandBuffer)                 \
  X(vkEndCommandBuffer)                   \
  X(vkCreateFence)                        \
  X(vkDestroyFence)                       \
  X(vkResetFences)                        \
  X(vkWaitForFences)                      \
  X(vkQueueSubmit2)                       \
  X(vkCreateQueryPool)                    \
  X(vkDestroyQueryPool)                   \
  X(vkGetQueryPoolResults)                \
  X(vkCmdResetQueryPool)                  \
  X(vkCmdWriteTimestamp2)                 \
  X(vkCmdPipelineBarrier2)                \
  X(vkCmdCopyBufferToImage)               \
  X(vkCmdCopyImageToBuffer)               \
  X(vkCmdCopyImage)                       \
  X(vkCmdBeginRendering)                  \
  X(vkCmdEndRendering)                    \
  X(vkCmdSetViewport)                     \
  X(vkCmdSetScissor)                      \
  X(vkCmdBindPipeline)                    \
  X(vkCmdBindDescriptorSets)              \
  X(vkCmdBindVertexBuffers)               \
  X(vkCmdDraw)

namespace ssrkit::vulkan {

#define SSRKIT_VULKAN_MEMBER(name) PFN_##name name = nullptr;

struct GlobalFunctions {
  SSRKIT_VULKAN_GLOBAL_FUNCTIONS(SSRKIT_VULKAN_MEMBER)
};

struct InstanceFunctions {
  SSRKIT_VULKAN_INSTANCE_FUNCTIONS(SSRKIT_VULKAN_MEMBER)
  SSRKIT_VULKAN_DEBUG_FUNCTIONS(SSRKIT_VULKAN_MEMBER)
};

struct DeviceFunctions {
  SSRKIT_VULKAN_DEVICE_FUNCTIONS(SSRKIT_VULKAN_MEMBER)
};

#undef SSRKIT_VULKAN_MEMBER

}  // namespace ssrkit::vulkan
