#include "native/depth_pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ssrkit {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::size_t entryIndex(const DepthPyramid& pyramid, int x, int row) {
  return 2 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(pyramid.width) +
              static_cast<std::size_t>(x));
}

void fillBase(const Image& dist_view, DepthPyramid& pyramid) {
  for (int y = 0; y < dist_view.size.height; ++y) {
    const float* const row = &dist_view.data[dist_view.index(0, y)];
    float* const entry = &pyramid.entries[entryIndex(pyramid, 0, y)];
    for (std::ptrdiff_t x = 0; x < dist_view.size.width; ++x) {
      entry[2 * x] = row[x];
      entry[2 * x + 1] = std::isinf(row[x]) ? 0.0F : row[x];
    }
  }
}

// The level that starts at `first_row` and is `width` x `height` cells, from the one that starts at
// `finer_row`.
void reduce(DepthPyramid& pyramid, int finer_row, int first_row, int width, int height) {
  for (int y = 0; y < height; ++y) {
    const float* const upper = &pyramid.entries[entryIndex(pyramid, 0, finer_row + 2 * y)];
    const float* const lower = &pyramid.entries[entryIndex(pyramid, 0, finer_row + 2 * y + 1)];
    float* const entry = &pyramid.entries[entryIndex(pyramid, 0, first_row + y)];
    for (std::ptrdiff_t x = 0; x < width; ++x) {
      const std::ptrdiff_t child = 4 * x;
      entry[2 * x] = std::min({upper[child], upper[child + 2], lower[child], lower[child + 2]});
      entry[2 * x + 1] = std::max({upper[child + 1], upper[child + 3], lower[child + 1], lower[child + 3]});
    }
  }
}

}  // namespace

DepthPyramid buildDepthPyramid(const Image& dist_view, int max_mip) {
  const int cell = 1 << max_mip;
  DepthPyramid pyramid{.width = (dist_view.size.width + cell - 1) / cell * cell,
                       .height = (dist_view.size.height + cell - 1) / cell * cell,
                       .entries = {}};
  pyramid.entries.resize(entryIndex(pyramid, 0, pyramid.rows()));
  for (std::size_t i = 0; i < pyramid.entries.size(); i += 2) {
    pyramid.entries[i] = kInfinity;
  }
  fillBase(dist_view, pyramid);
  int finer_row = 0;
  for (int level = 1; level <= max_mip; ++level) {
    const int first_row = pyramid.rows() - (pyramid.rows() >> level);
    reduce(pyramid, finer_row, first_row, pyramid.width >> level, pyramid.height >> level);
    finer_row = first_row;
  }
  return pyramid;
}

}  // namespace ssrkit
