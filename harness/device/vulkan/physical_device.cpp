#include "device/vulkan/physical_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "device/identity.h"
#include "device/vulkan/result.h"

namespace ssrkit::vulkan {

namespace {

std::string versionText(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

std::optional<std::uint32_t> graphicsQueueFamily(const std::vector<VkQueueFamilyProperties>& families) {
  const auto found = std::ranges::find_if(families, [](const VkQueueFamilyProperties& family) {
    return family.queueCount > 0 && (family.queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
  });
  if (found == families.end()) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(found - families.begin());
}

std::vector<VkQueueFamilyProperties> queueFamilies(const Instance& instance, VkPhysicalDevice device) {
  const InstanceFunctions& functions = instance.functions();
  std::uint32_t count = 0;
  functions.vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  functions.vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  families.resize(count);
  return families;
}

bool hasNeededFeatures(const Instance& instance, VkPhysicalDevice device) {
  VkPhysicalDeviceVulkan13Features features13{};
  features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  VkPhysicalDeviceFeatures2 features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features.pNext = &features13;
  instance.functions().vkGetPhysicalDeviceFeatures2(device, &features);
  return features13.dynamicRendering == VK_TRUE && features13.synchronization2 == VK_TRUE;
}

// Why this device cannot do the work; nothing when it can.
std::optional<std::string> objection(const Instance& instance, VkPhysicalDevice device,
                                     const VkPhysicalDeviceProperties& properties,
                                     const VulkanChoice& choice) {
  if (std::string_view(properties.deviceName).find(choice.device_name_part) == std::string_view::npos) {
    return fmt::format("its name does not contain '{}'", choice.device_name_part);
  }
  if (choice.wants_gpu && properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU) {
    return "it runs on the processor";
  }
  if (properties.apiVersion < VK_API_VERSION_1_3) {
    return fmt::format("it offers Vulkan {}, and 1.3 is needed", versionText(properties.apiVersion));
  }
  if (!hasNeededFeatures(instance, device)) {
    return "it lacks dynamic rendering or synchronization2";
  }
  if (!graphicsQueueFamily(queueFamilies(instance, device))) {
    return "it has no graphics queue";
  }
  return std::nullopt;
}

// Mesa's driver text is "Mesa 22.3.6 (LLVM 15.0.6)": LLVM stands in the device's name already. Others may
// leave it empty and have a version number of their own.
std::string driverVersion(const VkPhysicalDeviceDriverProperties& driver, std::uint32_t number) {
  const std::string_view text = driver.driverInfo;
  if (text.empty()) {
    return fmt::format("{} {}", driver.driverName, versionText(number));
  }
  return std::string(text.substr(0, text.find(" (")));
}

DeviceIdentity identityOf(const Instance& instance, VkPhysicalDevice device) {
  VkPhysicalDeviceDriverProperties driver{};
  driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &driver;
  instance.functions().vkGetPhysicalDeviceProperties2(device, &properties);
  const VkPhysicalDeviceProperties& core = properties.properties;
  CpuIdentity cpu = cpuIdentity();
  return {.id = {},
          .api = fmt::format("Vulkan {}", versionText(core.apiVersion)),
          .driver = core.deviceName,
          .version = driverVersion(driver, core.driverVersion),
          .cpu = std::move(cpu.model),
          .cpu_features = std::move(cpu.features)};
}

PhysicalDevice describe(const Instance& instance, VkPhysicalDevice handle,
                        const VkPhysicalDeviceLimits& limits) {
  const std::vector<VkQueueFamilyProperties> families = queueFamilies(instance, handle);
  PhysicalDevice device;
  device.handle = handle;
  device.limits = limits;
  device.queue_family = graphicsQueueFamily(families).value();
  device.timestamp_valid_bits = families[device.queue_family].timestampValidBits;
  device.identity = identityOf(instance, handle);
  instance.functions().vkGetPhysicalDeviceMemoryProperties(handle, &device.memory);
  return device;
}

Expected<std::vector<VkPhysicalDevice>> allPhysicalDevices(const Instance& instance,
                                                           const std::string& attempted) {
  std::uint32_t count = 0;
  VkResult result = instance.functions().vkEnumeratePhysicalDevices(instance.get(), &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  if (result == VK_SUCCESS && count > 0) {
    result = instance.functions().vkEnumeratePhysicalDevices(instance.get(), &count, devices.data());
    devices.resize(count);
  }
  if (result != VK_SUCCESS && result != VK_INCOMPLETE) {
    return resultError(attempted, "vkEnumeratePhysicalDevices", result);
  }
  return devices;
}

}  // namespace

Expected<PhysicalDevice> pickPhysicalDevice(const Instance& instance, const VulkanChoice& choice) {
  const std::string attempted = choice.wants_gpu
                                    ? "find a GPU with Vulkan"
                                    : fmt::format("find a Vulkan device named '{}'", choice.device_name_part);
  auto devices = allPhysicalDevices(instance, attempted);
  if (!devices) {
    return passOn(devices);
  }
  std::vector<std::string> reasons;
  for (const VkPhysicalDevice device : *devices) {
    VkPhysicalDeviceProperties properties;
    instance.functions().vkGetPhysicalDeviceProperties(device, &properties);
    const std::optional<std::string> why_not = objection(instance, device, properties, choice);
    if (!why_not) {
      return describe(instance, device, properties.limits);
    }
    reasons.push_back(fmt::format("{}: {}", properties.deviceName, *why_not));
  }
  auto error = setupError(
      attempted,
      reasons.empty() ? "no Vulkan device was seen" : fmt::format("none of the {} seen fits", reasons.size()),
      {}, fmt::format("install its driver (Debian: {}) and check VK_DRIVER_FILES", choice.driver_package));
  error.value().reasons = std::move(reasons);
  return error;
}

}  // namespace ssrkit::vulkan
