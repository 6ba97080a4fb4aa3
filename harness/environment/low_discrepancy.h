// Hammersley points: evenly spread over the unit square, the same ones each time (Pharr, Jakob, Humphreys,
// "Physically Based Rendering", 3rd ed., section 7.4).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace ssrkit {

// The radical inverse to base 2: the bits of `i` mirrored about the binary point.
[[nodiscard]] inline float radicalInverse2(std::uint32_t i) {
  i = (i << 16) | (i >> 16);
  i = ((i & 0x00FF00FFU) << 8) | ((i & 0xFF00FF00U) >> 8);
  i = ((i & 0x0F0F0F0FU) << 4) | ((i & 0xF0F0F0F0U) >> 4);
  i = ((i & 0x33333333U) << 2) | ((i & 0xCCCCCCCCU) >> 2);
  i = ((i & 0x55555555U) << 1) | ((i & 0xAAAAAAAAU) >> 1);
  return static_cast<float>(i >> 8) * 0x1p-24F;
}

// Point i of `count`; the first coordinate is at the middle of its stratum.
[[nodiscard]] inline glm::vec2 hammersley(int i, int count) {
  return {(static_cast<float>(i) + 0.5F) / static_cast<float>(count),
          radicalInverse2(static_cast<std::uint32_t>(i))};
}

}  // namespace ssrkit
