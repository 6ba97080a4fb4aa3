#pragma once

#include <cstdint>

namespace ssrkit {

// Wall time of what is done once for each program: GLSL to SPIR-V (or the cache's answer), and the driver's
// own program. What a driver puts off until the first draw is in a pass's cold time.
struct SetupTimes {
  std::int64_t compile_ns = 0;
  std::int64_t pipeline_ns = 0;

  bool operator==(const SetupTimes&) const = default;
};

}  // namespace ssrkit
