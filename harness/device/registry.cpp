#include "device/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "base/text.h"
#include "device/gl/gl_device.h"
#include "device/vulkan/vulkan_device.h"

namespace ssrkit {
namespace {

constexpr std::array kVulkanDriverFolders{"/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d",
                                          "/usr/share/vulkan/icd.d"};

// The loader's manifest of a driver, or "" where none is installed.
std::string findVulkanDriver(std::string_view name_part) {
  for (const char* const folder : kVulkanDriverFolders) {
    std::error_code unreadable;  // a folder that is not there has no drivers
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
      const std::string name = entry.path().filename().string();
      if (name.find(name_part) != std::string::npos && name.ends_with(".json")) {
        return entry.path().string();
      }
    }
  }
  return {};
}

DeviceEntry osmesaEntry() {
  return {.id = "gl-osmesa",
          .description = "OpenGL 4.5 core on OSMesa, Mesa's llvmpipe software rasteriser",
          .pipeline = "gl-llvmpipe",
          .rasteriser = "llvmpipe",
          .target = ShaderTarget::kOpenGl,
          .environment = {{"GALLIUM_DRIVER", "llvmpipe"}},
          .create = [] { return createOsmesaDevice("gl-osmesa"); }};
}

DeviceEntry lavapipeEntry() {
  const std::string driver = findVulkanDriver("lvp_icd");
  return {
      .id = "vk-lavapipe",
      .description = "Vulkan 1.3 on lavapipe, Mesa's software driver",
      .pipeline = "lavapipe",
      .rasteriser = "llvmpipe",
      .target = ShaderTarget::kVulkan,
      // Both names of one variable, for older and newer loaders; the third keeps Mesa's device-selection
      // layer out.
      .environment = {{"VK_DRIVER_FILES", driver}, {"VK_ICD_FILENAMES", driver}, {"NODEVICE_SELECT", "1"}},
      .create = [is_missing = driver.empty()]() -> Expected<std::unique_ptr<Device>> {
        if (is_missing) {
          return setupError("open the Vulkan driver lavapipe", "no lvp_icd*.json is installed",
                            kVulkanDriverFolders.back(), "install Debian's package mesa-vulkan-drivers");
        }
        return createVulkanDevice("vk-lavapipe", "llvmpipe");
      }};
}

}  // namespace

std::span<const DeviceEntry> deviceEntries() {
  static const std::array kEntries{osmesaEntry(), lavapipeEntry()};
  return kEntries;
}

Expected<const DeviceEntry*> findDevice(std::string_view id) {
  std::vector<std::string> ids;
  for (const DeviceEntry& entry : deviceEntries()) {
    if (entry.id == id) {
      return &entry;
    }
    ids.push_back(entry.id);
  }
  const std::optional<std::string> nearest = nearestName(id, ids);
  return inputError(fmt::format("find the device '{}'", id),
                    fmt::format("the devices are {}", joinNames(ids)), {},
                    nearest ? fmt::format("did you mean '{}'?", *nearest) : "choose one of them");
}

}  // namespace ssrkit
