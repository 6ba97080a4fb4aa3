#include "device/vulkan/library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string>
#include <utility>

namespace ssrkit::vulkan {

void Library::Close::operator()(void* library) const {
  ::dlclose(library);
}

Expected<Library> Library::open(const char* file_name) {
  std::string attempted = fmt::format("open the Vulkan loader {}", file_name);
  constexpr const char* kRemedy = "install the Debian package libvulkan1";
  Library result;
  result.library_.reset(::dlopen(file_name, RTLD_NOW | RTLD_LOCAL));
  if (!result.library_) {
    const char* reason = ::dlerror();
    return setupError(std::move(attempted), reason == nullptr ? "no reason given" : reason, {}, kRemedy);
  }
  result.get_instance_proc_addr_ =
      reinterpret_cast<PFN_vkGetInstanceProcAddr>(::dlsym(result.library_.get(), "vkGetInstanceProcAddr"));
  if (result.get_instance_proc_addr_ == nullptr) {
    return setupError(std::move(attempted), "it has no vkGetInstanceProcAddr", {}, kRemedy);
  }
#define SSRKIT_LOAD(name)                                                                                  \
  result.functions_.name = reinterpret_cast<PFN_##name>(result.get_instance_proc_addr_(nullptr, #name));   \
  if (result.functions_.name == nullptr) {                                                                 \
    return setupError(std::move(attempted), "it has no " #name " (a loader of Vulkan 1.0?)", {}, kRemedy); \
  }
  SSRKIT_VULKAN_GLOBAL_FUNCTIONS(SSRKIT_LOAD)
#undef SSRKIT_LOAD
  return result;
}

}  // namespace ssrkit::vulkan
