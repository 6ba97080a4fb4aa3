// Move-only owners of Vulkan objects.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "device/vulkan/result.h"

namespace ssrkit::vulkan {

template <class T>
using DestroyFunction = void(VKAPI_PTR*)(VkDevice, T, const VkAllocationCallbacks*);

template <class Info, class T>
using CreateFunction = VkResult(VKAPI_PTR*)(VkDevice, const Info*, const VkAllocationCallbacks*, T*);

// One object of a VkDevice, which must outlive it.
template <class T>
class Handle {
 public:
  Handle() = default;
  Handle(VkDevice device, T object, DestroyFunction<T> destroy)
      : device_(device), object_(object), destroy_(destroy) {}
  Handle(Handle&& other) noexcept
      : device_(other.device_),
        object_(std::exchange(other.object_, VK_NULL_HANDLE)),
        destroy_(other.destroy_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(object_, other.object_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  ~Handle() {
    if (object_ != VK_NULL_HANDLE) {
      destroy_(device_, object_, nullptr);
    }
  }

  [[nodiscard]] T get() const { return object_; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  T object_ = VK_NULL_HANDLE;
  DestroyFunction<T> destroy_ = nullptr;
};

// Calls `create` (its name is for the error) and owns what it made.
template <class Info, class T>
[[nodiscard]] Expected<Handle<T>> makeHandle(VkDevice device, std::string_view function,
                                             CreateFunction<Info, T> create, DestroyFunction<T> destroy,
                                             const Info& info, std::string_view attempted) {
  T object = VK_NULL_HANDLE;
  const VkResult result = create(device, &info, nullptr, &object);
  if (result != VK_SUCCESS) {
    return resultError(std::string(attempted), function, result);
  }
  return Handle<T>(device, object, destroy);
}

}  // namespace ssrkit::vulkan
