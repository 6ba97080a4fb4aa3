#include "device/vulkan/instance.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "device/vulkan/result.h"

namespace ssrkit::vulkan {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr const char* kAttemptedInstance = "create a Vulkan instance";

bool hasLayer(const GlobalFunctions& functions, std::string_view name) {
  std::uint32_t count = 0;
  functions.vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  functions.vkEnumerateInstanceLayerProperties(&count, layers.data());
  layers.resize(count);
  return std::any_of(layers.begin(), layers.end(),
                     [&](const VkLayerProperties& layer) { return layer.layerName == name; });
}

bool hasExtension(const GlobalFunctions& functions, std::string_view name) {
  std::uint32_t count = 0;
  functions.vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  functions.vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
  extensions.resize(count);
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const VkExtensionProperties& extension) { return extension.extensionName == name; });
}

VkApplicationInfo applicationInfo() {
  VkApplicationInfo info{};
  info.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  info.pApplicationName = "ssrkit";
  info.apiVersion = VK_API_VERSION_1_3;
  return info;
}

}  // namespace

Expected<ValidationChecks> parseValidation(std::string_view text) {
  ValidationChecks checks;
  if (text == "1") {
    return ValidationChecks{.core = true, .sync = true};
  }
  for (const std::string& word : split(text, ',')) {
    if (word == "core") {
      checks.core = true;
    } else if (word == "sync") {
      checks.sync = true;
    } else if (word == "gpu") {
      checks.gpu = true;
    } else if (!word.empty()) {
      return inputError("choose what is validated", fmt::format("'{}' is no kind of check", word),
                        "SSRKIT_VALIDATION", "write a list of core, sync and gpu");
    }
  }
  return checks;
}

Expected<std::unique_ptr<Instance>> Instance::create(Library library, ValidationChecks checks) {
  std::unique_ptr<Instance> instance(new Instance(std::move(library)));
  const GlobalFunctions& functions = instance->library_.functions();
  if (checks.any() && !hasLayer(functions, kValidationLayer)) {
    return setupError(kAttemptedInstance,
                      fmt::format("SSRKIT_VALIDATION asks for it, but {} is not installed", kValidationLayer),
                      {}, "install the Debian package vulkan-validationlayers or unset SSRKIT_VALIDATION");
  }
  instance->checks_ = checks;
  instance->has_debug_utils_ = hasExtension(functions, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  Expected<void> done = instance->createInstance();
  if (done) {
    done = instance->loadFunctions();
  }
  if (done) {
    done = instance->createMessenger();
  }
  if (!done) {
    return passOn(done);
  }
  return instance;
}

Expected<void> Instance::createInstance() {
  std::vector<VkValidationFeatureEnableEXT> enabled;
  if (checks_.sync) {
    enabled.push_back(VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT);
  }
  if (checks_.gpu) {
    enabled.push_back(VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT);
    enabled.push_back(VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_RESERVE_BINDING_SLOT_EXT);
  }
  const VkValidationFeatureDisableEXT no_core = VK_VALIDATION_FEATURE_DISABLE_CORE_CHECKS_EXT;
  VkValidationFeaturesEXT features{};
  features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size());
  features.pEnabledValidationFeatures = enabled.data();
  features.disabledValidationFeatureCount = checks_.core ? 0 : 1;
  features.pDisabledValidationFeatures = &no_core;

  std::vector<const char*> extensions;
  if (has_debug_utils_) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  }
  if (checks_.any()) {
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
  }
  const VkApplicationInfo application = applicationInfo();
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pNext = checks_.any() ? &features : nullptr;
  info.pApplicationInfo = &application;
  info.enabledLayerCount = checks_.any() ? 1 : 0;
  info.ppEnabledLayerNames = &kValidationLayer;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  const VkResult result = library_.functions().vkCreateInstance(&info, nullptr, &instance_);
  if (result != VK_SUCCESS) {
    instance_ = VK_NULL_HANDLE;
    return resultError(kAttemptedInstance, "vkCreateInstance", result);
  }
#ifdef __SANITIZE_ADDRESS__
  // They keep things for ever: once their libraries are unloaded, those would look like leaks of ours.
  for (const char* const library : {"libvulkan_lvp.so", "libVkLayer_khronos_validation.so"}) {
    static_cast<void>(dlopen(library, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE));
  }
#endif
  return {};
}

Expected<void> Instance::loadFunctions() {
  const PFN_vkGetInstanceProcAddr address_of = library_.getInstanceProcAddr();
#define SSRKIT_LOAD_OPTIONAL(name) \
  functions_.name = reinterpret_cast<PFN_##name>(address_of(instance_, #name));
#define SSRKIT_LOAD(name)                                                 \
  SSRKIT_LOAD_OPTIONAL(name)                                              \
  if (functions_.name == nullptr) {                                       \
    return setupError(kAttemptedInstance, "the loader has no " #name, {}, \
                      "update the Vulkan loader (Debian: libvulkan1)");   \
  }
  SSRKIT_VULKAN_INSTANCE_FUNCTIONS(SSRKIT_LOAD)
  SSRKIT_VULKAN_DEBUG_FUNCTIONS(SSRKIT_LOAD_OPTIONAL)
#undef SSRKIT_LOAD
#undef SSRKIT_LOAD_OPTIONAL
  return {};
}

Expected<void> Instance::createMessenger() {
  if (!has_debug_utils_ || functions_.vkCreateDebugUtilsMessengerEXT == nullptr) {
    return {};
  }
  const VkDebugUtilsMessengerCreateInfoEXT info = messages_.messengerInfo();
  const VkResult result = functions_.vkCreateDebugUtilsMessengerEXT(instance_, &info, nullptr, &messenger_);
  if (result != VK_SUCCESS) {
    messenger_ = VK_NULL_HANDLE;
    return resultError("listen to the driver's messages", "vkCreateDebugUtilsMessengerEXT", result);
  }
  return {};
}

Instance::~Instance() {
  if (messenger_ != VK_NULL_HANDLE) {
    functions_.vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  }
  if (functions_.vkDestroyInstance != nullptr) {
    functions_.vkDestroyInstance(instance_, nullptr);
  }
  for (const std::string& message : messages_.drain()) {
    fmt::print(stderr, "vulkan: {}\n", message);
  }
}

}  // namespace ssrkit::vulkan
