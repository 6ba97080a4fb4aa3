// The processor under a software device: its features change the bits that a rasteriser's JIT makes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ssrkit {

struct CpuIdentity {
  std::string model;                  // "unknown" where the kernel does not say
  std::vector<std::string> features;  // those that code generators ask for, in a fixed order
};

// Of /proc/cpuinfo's first processor.
[[nodiscard]] CpuIdentity parseCpuInfo(std::string_view cpuinfo);

// This machine's.
[[nodiscard]] CpuIdentity cpuIdentity();

}  // namespace ssrkit
