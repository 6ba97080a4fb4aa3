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
#include "shader/compiler.h"

namespace ssrkit {

struct DeviceEntry {
  std::string id;           // "gl-osmesa"
  std::string description;  // one line for `ssrkit devices`
  ShaderTarget target;
  // What the worker's environment needs before any driver is loaded (driver choice is process-wide).
  std::vector<std::pair<std::string, std::string>> environment;
  std::function<Expected<std::unique_ptr<Device>>()> create;
};

[[nodiscard]] std::span<const DeviceEntry> deviceEntries();

// Fails with the list of known ids.
[[nodiscard]] Expected<const DeviceEntry*> findDevice(std::string_view id);

// What the start-up probe found on a device; stored with the results.
struct DeviceTraits {
  std::uint32_t loop_cap = 0;  // iterations after which loops are cut without a word; 0: none up to 262,144
  bool device_timer_usable = false;  // API timestamps agree with wall time within 20 %
  std::string shader_input;          // "SPIR-V"
};

[[nodiscard]] Expected<DeviceTraits> probeTraits(Device& device);

}  // namespace ssrkit
