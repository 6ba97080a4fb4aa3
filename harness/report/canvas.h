// Rectangles and pictures on a larger picture. What falls outside is cut off.
#pragma once

#include "image/byte_image.h"

namespace ssrkit {

struct CanvasRect {
  int x = 0;
  int y = 0;
  Size size;
};

void fillRect(ByteImage& canvas, const CanvasRect& rect, Rgb8 colour);

// Each dot of `picture` becomes `grow` x `grow` dots.
void paste(ByteImage& canvas, int x, int y, const ByteImage& picture, int grow);

}  // namespace ssrkit
