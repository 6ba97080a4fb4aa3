// The devices the kit knows, as rows of data.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "device/traits.h"  // part of the seam: whoever asks for a device asks for its traits
#include "shader/compiler.h"

namespace ssrkit {

struct DeviceEntry {
  std::string id;           // "gl-osmesa"
  std::string description;  // one line for `ssrkit devices`
  // What its images may be compared by (tolerance_class.h): the code that turns a shader into pixels, front
  // end included, and the code that draws triangles and runs shaders.
  std::string pipeline;     // "gl-llvmpipe"
  std::string rasteriser;   // "llvmpipe"
  bool is_software = true;  // runs on the processor: any machine with its packages has it
  ShaderTarget target = ShaderTarget::kOpenGl;
  // What the worker's environment needs before any driver is loaded (driver choice is process-wide).
  std::vector<std::pair<std::string, std::string>> environment;
  std::function<Expected<std::unique_ptr<Device>>()> create;
};

// Reads the names of the installed Vulkan drivers once; loads none of them.
[[nodiscard]] std::span<const DeviceEntry> deviceEntries();

// Fails with the list of known ids.
[[nodiscard]] Expected<const DeviceEntry*> findDevice(std::string_view id);

}  // namespace ssrkit
