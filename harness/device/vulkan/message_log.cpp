#include "device/vulkan/message_log.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace ssrkit::vulkan {

namespace {

// What the layer says of its own checks where a device lacks 64-bit integers: the kit uses no device
// addresses.
bool isOfDeviceAddresses(std::string_view text) {
  return text.find("No buffer device address checking will be attempted") != std::string_view::npos;
}

}  // namespace

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
  const char* const text = data.pMessage == nullptr ? "(no text)" : data.pMessage;
  if (isOfDeviceAddresses(text)) {
    return;
  }
  const std::scoped_lock lock(mutex_);
  error_count_ += is_error ? 1 : 0;
  messages_.push_back(fmt::format("{}: {}", is_error ? "error" : "warning", text));
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
