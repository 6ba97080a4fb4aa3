// Maps are computed in float.
#pragma once

#include <numbers>

namespace ssrkit {

inline constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace ssrkit
