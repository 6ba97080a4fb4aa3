// The depth pyramid of the shaders, built on the CPU.
#pragma once

#include <vector>

#include "image/image.h"

namespace ssrkit {

struct DepthPyramid {
  int width = 0;   // cells a row: the image's width, padded to whole cells of the coarsest level
  int height = 0;  // rows of level 0, padded likewise
  std::vector<float>
      entries;  // least and greatest dist_view of each cell (+inf and 0 where all is background)

  // Level m starts at row rows() * (1 - 2^-m).
  [[nodiscard]] int rows() const { return 2 * height; }
};

// Levels 0..max_mip of an image of one channel, metres, +inf for background.
[[nodiscard]] DepthPyramid buildDepthPyramid(const Image& dist_view, int max_mip);

}  // namespace ssrkit
