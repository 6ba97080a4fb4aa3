#include "device/registry.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "base/text.h"
#include "device/gl/gl_device.h"
#include "device/vulkan/driver_file.h"
#include "device/vulkan/vulkan_device.h"

namespace ssrkit {
namespace {

using Environment = std::vector<std::pair<std::string, std::string>>;

DeviceEntry glEntry(GlDeviceChoice choice, std::string description, Environment environment) {
  DeviceEntry entry;
  entry.id = choice.id;
  entry.description = std::move(description);
  entry.target = ShaderTarget::kOpenGl;
  entry.environment = std::move(environment);
  entry.create = [choice = std::move(choice)] { return createGlDevice(choice); };
  return entry;
}

// What the loader needs to see one driver only: both names of one variable, for older and newer loaders; the
// third keeps Mesa's device-selection layer out.
Environment onlyVulkanDriver(const std::string& file) {
  return {{"VK_DRIVER_FILES", file}, {"VK_ICD_FILENAMES", file}, {"NODEVICE_SELECT", "1"}};
}

DeviceEntry vulkanSoftwareEntry(std::string id, std::string description, std::string_view file_part,
                                VulkanChoice choice) {
  DeviceEntry entry;
  entry.id = std::move(id);
  entry.description = std::move(description);
  entry.target = ShaderTarget::kVulkan;
  const std::string file = vulkan::findDriverFile(file_part);
  entry.environment = onlyVulkanDriver(file);
  entry.create = [id = entry.id, file_part = std::string(file_part), is_missing = file.empty(),
                  choice = std::move(choice)]() -> Expected<std::unique_ptr<Device>> {
    if (is_missing) {
      return setupError(fmt::format("open the device '{}'", id),
                        fmt::format("no Vulkan driver {}*.json is installed", file_part), {},
                        fmt::format("install Debian's package {}", choice.driver_package));
    }
    return createVulkanDevice(id, choice);
  };
  return entry;
}

DeviceEntry osmesaEntry() {
  DeviceEntry entry = glEntry({.id = "gl-osmesa", .renderer_part = "llvmpipe"},
                              "OpenGL 4.5 core on OSMesa, Mesa's llvmpipe software rasteriser",
                              {{"GALLIUM_DRIVER", "llvmpipe"}});
  entry.pipeline = "gl-llvmpipe";
  entry.rasteriser = "llvmpipe";
  return entry;
}

DeviceEntry lavapipeEntry() {
  DeviceEntry entry = vulkanSoftwareEntry("vk-lavapipe", "Vulkan 1.3 on lavapipe, Mesa's software driver",
                                          "lvp_icd", {.device_name_part = "llvmpipe"});
  entry.pipeline = "lavapipe";
  entry.rasteriser = "llvmpipe";
  return entry;
}

DeviceEntry eglEntry() {
  DeviceEntry entry =
      glEntry({.id = "gl-egl", .platform = GlPlatform::kEglSurfaceless, .renderer_part = "llvmpipe"},
              "OpenGL 4.5 core on EGL without a surface, llvmpipe: where Mesa no longer has OSMesa",
              {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"GALLIUM_DRIVER", "llvmpipe"}});
  entry.pipeline = "gl-llvmpipe";
  entry.rasteriser = "llvmpipe";
  return entry;
}

// Without LIBGL_ALWAYS_SOFTWARE zink takes no Vulkan device that is a processor.
DeviceEntry zinkEntry() {
  Environment environment = onlyVulkanDriver(vulkan::findDriverFile("lvp_icd"));
  environment.insert(environment.end(), {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"GALLIUM_DRIVER", "zink"}});
  DeviceEntry entry =
      glEntry({.id = "gl-zink", .platform = GlPlatform::kEglSurfaceless, .renderer_part = "zink (llvmpipe"},
              "OpenGL 4.6 on zink, Mesa's OpenGL over Vulkan, over lavapipe", std::move(environment));
  entry.pipeline = "lavapipe";
  entry.rasteriser = "llvmpipe";
  return entry;
}

DeviceEntry glslEntry() {
  DeviceEntry entry = glEntry(
      {.id = "gl-glsl", .shader_input = GlShaderInput::kGlsl450, .renderer_part = "llvmpipe"},
      "gl-osmesa by its other front door: GLSL 450 from the same SPIR-V", {{"GALLIUM_DRIVER", "llvmpipe"}});
  entry.pipeline = "gl-llvmpipe-glsl";
  entry.rasteriser = "llvmpipe";
  return entry;
}

DeviceEntry softpipeEntry() {
  DeviceEntry entry =
      glEntry({.id = "gl-softpipe", .shader_input = GlShaderInput::kGlsl330, .renderer_part = "softpipe"},
              "OpenGL 3.3 core on OSMesa, Mesa's softpipe interpreter: slow, for small sizes",
              {{"GALLIUM_DRIVER", "softpipe"}});
  entry.pipeline = entry.rasteriser = "softpipe";
  return entry;
}

DeviceEntry swiftshaderEntry() {
  DeviceEntry entry = vulkanSoftwareEntry(
      "vk-swiftshader", "Vulkan 1.3 on SwiftShader, the browser's software driver", "vk_swiftshader_icd",
      {.device_name_part = "SwiftShader", .driver_package = "chromium-common"});
  entry.pipeline = entry.rasteriser = "swiftshader";
  return entry;
}

DeviceEntry glGpuEntry() {
  DeviceEntry entry = glEntry({.id = "gl-gpu", .platform = GlPlatform::kEglGpu, .renderer_part = {}},
                              "OpenGL on the first GPU that EGL lists", {});
  entry.pipeline = entry.rasteriser = "gl-gpu";
  entry.is_software = false;
  return entry;
}

DeviceEntry vulkanGpuEntry() {
  DeviceEntry entry;
  entry.id = entry.pipeline = entry.rasteriser = "vk-gpu";
  entry.description = "Vulkan on the first device that is no processor";
  entry.is_software = false;
  entry.target = ShaderTarget::kVulkan;
  entry.environment = {{"NODEVICE_SELECT", "1"}};
  entry.create = [] { return createVulkanDevice("vk-gpu", {.device_name_part = {}, .wants_gpu = true}); };
  return entry;
}

}  // namespace

std::span<const DeviceEntry> deviceEntries() {
  static const std::array kEntries{osmesaEntry(),      lavapipeEntry(), eglEntry(),
                                   zinkEntry(),        glslEntry(),     softpipeEntry(),
                                   swiftshaderEntry(), glGpuEntry(),    vulkanGpuEntry()};
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
