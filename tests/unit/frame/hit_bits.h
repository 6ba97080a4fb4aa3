// The bits of a hit's position and distance: 0 and -0 differ, and a NaN is equal to itself.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "image/ray_record.h"

namespace ssrkit {

inline std::array<std::uint32_t, 3> pointBits(const RayHit& hit) {
  return {std::bit_cast<std::uint32_t>(hit.px_x), std::bit_cast<std::uint32_t>(hit.px_y),
          std::bit_cast<std::uint32_t>(hit.t_m)};
}

}  // namespace ssrkit
