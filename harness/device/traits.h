// What a device does that its documentation does not say, found by a probe when it starts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "shader/compiler.h"

namespace ssrkit {

// Stored with the results.
struct DeviceTraits {
  std::uint32_t loop_cap = 0;  // iterations after which loops are cut without a word; 0: none up to 262,144
  bool device_timer_usable = false;  // API timestamps agree with wall time within 20 %
  std::string shader_input;          // "SPIR-V", "GLSL 330"
};

// Compiles `shader_root`/probe for `target`, the device's own, and draws it a few times (about 0.1 s).
[[nodiscard]] Expected<DeviceTraits> probeTraits(Device& device, ShaderTarget target,
                                                 const std::filesystem::path& shader_root);

}  // namespace ssrkit
