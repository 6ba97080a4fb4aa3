#include "device/pass_clock.h"

#include <ctime>

#include "base/check.h"

namespace ssrkit {
namespace {

std::int64_t clockNs(clockid_t clock) {
  timespec now{};
  SSRKIT_CHECK_EQ(clock_gettime(clock, &now), 0);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

std::int64_t processCpuNs() {
  return clockNs(CLOCK_PROCESS_CPUTIME_ID);
}

PassTime& operator+=(PassTime& sum, const PassTime& time) {
  sum.wall_ns += time.wall_ns;
  sum.cpu_ns += time.cpu_ns;
  sum.device_ns =
      sum.device_ns && time.device_ns ? std::optional(*sum.device_ns + *time.device_ns) : std::nullopt;
  return sum;
}

PassClock::PassClock() : wall_start_ns_(clockNs(CLOCK_MONOTONIC)), cpu_start_ns_(processCpuNs()) {}

PassTime PassClock::elapsed() const {
  const std::int64_t cpu_ns = processCpuNs() - cpu_start_ns_;
  return {.wall_ns = clockNs(CLOCK_MONOTONIC) - wall_start_ns_, .cpu_ns = cpu_ns, .device_ns = {}};
}

}  // namespace ssrkit
