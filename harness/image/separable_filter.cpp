#include "image/separable_filter.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace ssrkit {

namespace {

// One line of texels, `step` apart, with its ends repeated on both sides so that the loop needs no tests.
void filterLine(const float* from, float* to, std::size_t count, std::size_t step, const Kernel& kernel,
                std::vector<double>& padded) {
  const std::size_t radius = kernel.weights.size() / 2;
  padded.assign(count + 2 * radius, from[0]);
  for (std::size_t i = 0; i < count; ++i) {
    padded[radius + i] = from[i * step];
  }
  std::fill(padded.end() - static_cast<std::ptrdiff_t>(radius), padded.end(), padded[radius + count - 1]);
  for (std::size_t i = 0; i < count; ++i) {
    to[i * step] = static_cast<float>(std::inner_product(
        kernel.weights.begin(), kernel.weights.end(), padded.begin() + static_cast<std::ptrdiff_t>(i), 0.0));
  }
}

}  // namespace

double Kernel::sum() const {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

Kernel Kernel::normalised() const {
  const double total = sum();
  Kernel kernel = *this;
  for (double& weight : kernel.weights) {
    weight /= total;
  }
  return kernel;
}

Kernel Kernel::balanced() const {
  double positive = 0.0;
  double negative = 0.0;
  for (const double weight : weights) {
    (weight > 0.0 ? positive : negative) += weight;
  }
  Kernel kernel = *this;
  for (double& weight : kernel.weights) {
    weight /= weight > 0.0 ? positive : -negative;
  }
  return kernel;
}

Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  const auto width = static_cast<std::size_t>(plane.size.width);
  const auto height = static_cast<std::size_t>(plane.size.height);
  Plane rows{plane.size, std::vector<float>(plane.data.size())};
  Plane result = rows;
  std::vector<double> padded;
  for (std::size_t y = 0; y < height; ++y) {
    filterLine(&plane.data[y * width], &rows.data[y * width], width, 1, along_x, padded);
  }
  for (std::size_t x = 0; x < width; ++x) {
    filterLine(&rows.data[x], &result.data[x], height, width, along_y, padded);
  }
  return result;
}

}  // namespace ssrkit
