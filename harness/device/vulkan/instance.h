// A Vulkan instance with its messenger.
#pragma once

#include <memory>

#include "base/error.h"
#include "device/vulkan/functions.h"
#include "device/vulkan/library.h"
#include "device/vulkan/message_log.h"

namespace ssrkit::vulkan {

class Instance {
 public:
  // `validate` asks for the Khronos validation layer, core and synchronization checks; it is an error
  // (kSetup) when the layer is not installed, because a run that was asked to validate must not pass without.
  [[nodiscard]] static Expected<std::unique_ptr<Instance>> create(Library library, bool validate);
  // Messages that nobody drained (objects still alive when the device went) are printed to stderr.
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] VkInstance get() const { return instance_; }
  [[nodiscard]] const InstanceFunctions& functions() const { return functions_; }
  [[nodiscard]] MessageLog& messages() { return messages_; }
  [[nodiscard]] bool validates() const { return validates_; }

 private:
  explicit Instance(Library library) : library_(std::move(library)) {}
  [[nodiscard]] Expected<void> createInstance();
  [[nodiscard]] Expected<void> loadFunctions();
  [[nodiscard]] Expected<void> createMessenger();

  Library library_;
  MessageLog messages_;
  InstanceFunctions functions_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  bool validates_ = false;
  bool has_debug_utils_ = false;
};

}  // namespace ssrkit::vulkan
