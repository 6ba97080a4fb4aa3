// Clocks are read in nanoseconds and told in milliseconds.
#pragma once

namespace ssrkit {

inline constexpr double kMsPerNs = 1e-6;

}  // namespace ssrkit
