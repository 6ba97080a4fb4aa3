#pragma once

#include <cstdint>

namespace ssrkit {

inline constexpr std::int64_t kNsPerMs = 1'000'000;

}  // namespace ssrkit
