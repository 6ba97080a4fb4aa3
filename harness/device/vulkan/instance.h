// A Vulkan instance with its messenger.
#pragma once

#include <memory>
#include <string_view>

#include "base/error.h"
#include "device/vulkan/functions.h"
#include "device/vulkan/library.h"
#include "device/vulkan/message_log.h"

namespace ssrkit::vulkan {

// What the Khronos validation layer checks.
struct ValidationChecks {
  bool core = false;
  bool sync = false;  // synchronization: hazards between commands of one command buffer
  bool gpu = false;   // GPU-assisted: shaders are rewritten and what they access is checked as they run

  [[nodiscard]] bool any() const { return core || sync || gpu; }
};

// "core,sync,gpu" or a part of it; "1" is core and sync, "" nothing.
[[nodiscard]] Expected<ValidationChecks> parseValidation(std::string_view text);

class Instance {
 public:
  // It is an error (kSetup) when checks are asked for and the layer is not installed, because a run that was
  // asked to validate must not pass without.
  [[nodiscard]] static Expected<std::unique_ptr<Instance>> create(Library library, ValidationChecks checks);
  // Messages that nobody drained (objects still alive when the device went) are printed to stderr.
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] VkInstance get() const { return instance_; }
  [[nodiscard]] const InstanceFunctions& functions() const { return functions_; }
  [[nodiscard]] MessageLog& messages() { return messages_; }
  [[nodiscard]] const ValidationChecks& checks() const { return checks_; }

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
  ValidationChecks checks_;
  bool has_debug_utils_ = false;
};

}  // namespace ssrkit::vulkan
