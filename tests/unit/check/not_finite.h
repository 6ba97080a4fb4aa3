// What a depth or a coordinate is where there is no number for it.
#pragma once

#include <limits>

namespace ssrkit {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

}  // namespace ssrkit
