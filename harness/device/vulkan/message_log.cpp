#include "device/vulkan/message_log.h"

#include <fmt/format.h>

#include <utility>

namespace ssrkit::vulkan {

VkDebugUtilsMessengerCreateInfoEXT MessageLog::messengerInfo() {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = &MessageLog::receive;
  info.pUserData = this;
  return info;
}

VkBool32 MessageLog::receive(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                             VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                             const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
  static_cast<MessageLog*>(log)->add(severity, *data);
  return VK_FALSE;  // VK_TRUE would make the call fail, which only tests of layers may ask for
}

void MessageLog::add(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                     const VkDebugUtilsMessengerCallbackDataEXT& data) {
  const bool is_error = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  const std::scoped_lock lock(mutex_);
  error_count_ += is_error ? 1 : 0;
  messages_.push_back(fmt::format("{}: {}", is_error ? "error" : "warning",
                                  data.pMessage == nullptr ? "(no text)" : data.pMessage));
}

std::vector<std::string> MessageLog::drain() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(messages_, {});
}

std::size_t MessageLog::errorCount() const {
  const std::scoped_lock lock(mutex_);
  return error_count_;
}

}  // namespace ssrkit::vulkan
