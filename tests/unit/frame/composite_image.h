// The image that the composites are held to their formulas on: a column an angle or a roughness, a row a
// share.
#pragma once

#include <array>

#include "pass_test.h"

namespace ssrkit {

inline constexpr Size kCompositeSize{91, 5};  // a column a degree

// Alpha, metallic, visibility or mask by row: 0, a quarter, a half, three quarters, 1.
inline double shareOfRow(int y) {
  return y / 4.0;
}

inline Image uniformImage(double r, double g, double b, double a) {
  return imageOf(kCompositeSize, [&](int, int) { return std::array{r, g, b, a}; });
}

}  // namespace ssrkit
