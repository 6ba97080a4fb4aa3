// Wall and process CPU time around a pass. CPU time is the steadier of the two on a shared machine: it sums
// the rasteriser's threads and leaves out everybody else's.
#pragma once

#include <cstdint>

#include "device/device.h"

namespace ssrkit {

// Nanoseconds of CPU that all threads of this process have used (CLOCK_PROCESS_CPUTIME_ID).
[[nodiscard]] std::int64_t processCpuNs();

// What two passes took together; on the device where both know.
PassTime& operator+=(PassTime& sum, const PassTime& time);

// Starts when made.
class PassClock {
 public:
  PassClock();

  // Time since the start; device_ns is left to the caller.
  [[nodiscard]] PassTime elapsed() const;

 private:
  std::int64_t wall_start_ns_;
  std::int64_t cpu_start_ns_;
};

}  // namespace ssrkit
