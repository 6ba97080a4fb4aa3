#include "report/canvas.h"

#include <algorithm>

#include "base/check.h"

namespace ssrkit {

namespace {

CanvasRect clipped(const CanvasRect& rect, Size canvas) {
  const int x_begin = std::clamp(rect.x, 0, canvas.width);
  const int y_begin = std::clamp(rect.y, 0, canvas.height);
  const int x_end = std::clamp(rect.x + rect.size.width, x_begin, canvas.width);
  const int y_end = std::clamp(rect.y + rect.size.height, y_begin, canvas.height);
  return {x_begin, y_begin, {x_end - x_begin, y_end - y_begin}};
}

}  // namespace

void fillRect(ByteImage& canvas, const CanvasRect& rect, Rgb8 colour) {
  SSRKIT_CHECK_EQ(canvas.channel_count, 3);
  const CanvasRect inside = clipped(rect, canvas.size);
  for (int y = inside.y; y < inside.y + inside.size.height; ++y) {
    std::uint8_t* out = &canvas.data[canvas.index(0, y)] + static_cast<std::ptrdiff_t>(inside.x) * 3;
    for (int x = 0; x < inside.size.width; ++x) {
      out = std::ranges::copy(colour, out).out;
    }
  }
}

void paste(ByteImage& canvas, int x, int y, const ByteImage& picture, int grow) {
  SSRKIT_CHECK_EQ(canvas.channel_count, 3);
  SSRKIT_CHECK_EQ(picture.channel_count, 3);
  const CanvasRect inside =
      clipped({x, y, {picture.size.width * grow, picture.size.height * grow}}, canvas.size);
  for (int row = inside.y; row < inside.y + inside.size.height; ++row) {
    for (int column = inside.x; column < inside.x + inside.size.width; ++column) {
      const std::uint8_t* const dot = &picture.data[picture.index((column - x) / grow, (row - y) / grow)];
      std::copy_n(dot, 3, &canvas.data[canvas.index(column, row)]);
    }
  }
}

}  // namespace ssrkit
