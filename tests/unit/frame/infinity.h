// What dist_view is where there is no surface.
#pragma once

#include <limits>

namespace ssrkit {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace ssrkit
