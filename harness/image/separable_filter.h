// Filters that are a product of one along x and one along y, over one channel.
#pragma once

#include <vector>

#include "base/size.h"

namespace ssrkit {

struct Plane {
  Size size;
  std::vector<float> data;
};

// 2 * radius + 1 weights; weights[radius] is the middle one.
struct Kernel {
  std::vector<double> weights;

  [[nodiscard]] double sum() const;
  [[nodiscard]] Kernel normalised() const;  // the sum is 1
  [[nodiscard]] Kernel balanced() const;    // the positive weights sum to 1, the negative ones to -1
};

template <class Function>
[[nodiscard]] Kernel kernelOf(int radius, Function function) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) {
    kernel.weights.push_back(function(static_cast<double>(x)));
  }
  return kernel;
}

// Weight k of `along_x` meets the texel k - radius to the right. Beyond the borders the border's texels go
// on.
[[nodiscard]] Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y);

}  // namespace ssrkit
