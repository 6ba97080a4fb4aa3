// What the driver, the loader and the validation layer had to say.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace ssrkit::vulkan {

// Filled by a debug messenger, from any thread. Warnings and errors are kept; pure performance warnings are
// not, because they say nothing about the result.
class MessageLog {
 public:
  // The messenger that fills this log, which must outlive it.
  [[nodiscard]] VkDebugUtilsMessengerCreateInfoEXT messengerInfo();

  [[nodiscard]] std::vector<std::string> drain();
  [[nodiscard]] std::size_t errorCount() const;  // since the start, drained ones included

 private:
  static VkBool32 VKAPI_PTR receive(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                    VkDebugUtilsMessageTypeFlagsEXT types,
                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void* log);
  void add(VkDebugUtilsMessageSeverityFlagBitsEXT severity, const VkDebugUtilsMessengerCallbackDataEXT& data);

  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
  std::size_t error_count_ = 0;
};

}  // namespace ssrkit::vulkan
