// How alike two devices' answers to one shader must be.
#pragma once

#include <string_view>

#include "device/registry.h"

namespace ssrkit {

enum class ToleranceClass {
  kSamePipeline,    // P: the same bits
  kSameRasteriser,  // R: a few ulp, and decisions that hang on them; the same bits over one uploaded G-buffer
  kOther,           // X: edges may lie elsewhere, too: position, percentiles
};

// Symmetric; a device and itself are of the same pipeline.
[[nodiscard]] ToleranceClass toleranceClass(const DeviceEntry& a, const DeviceEntry& b);

// "P", "R" or "X"
[[nodiscard]] std::string_view letterOf(ToleranceClass tolerance);

}  // namespace ssrkit
