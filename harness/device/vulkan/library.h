// The Vulkan loader as a library opened at run time.
#pragma once

#include <memory>

#include "base/error.h"
#include "device/vulkan/functions.h"

namespace ssrkit::vulkan {

inline constexpr const char* kLoaderName = "libvulkan.so.1";

class Library {
 public:
  // Fails (kSetup) with the linker's reason and the Debian package that brings the loader.
  [[nodiscard]] static Expected<Library> open(const char* file_name = kLoaderName);

  [[nodiscard]] const GlobalFunctions& functions() const { return functions_; }
  [[nodiscard]] PFN_vkGetInstanceProcAddr getInstanceProcAddr() const { return get_instance_proc_addr_; }

 private:
  struct Close {
    void operator()(void* library) const;
  };

  std::unique_ptr<void, Close> library_;
  PFN_vkGetInstanceProcAddr get_instance_proc_addr_ = nullptr;
  GlobalFunctions functions_;
};

}  // namespace ssrkit::vulkan
