#include "image/text_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace ssrkit {
namespace {

ByteImage white(Size size) {
  ByteImage picture(size, 3);
  std::ranges::fill(picture.data, std::uint8_t{255});
  return picture;
}

bool hasInk(const ByteImage& picture, int x_begin, int x_end) {
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = x_begin; x < x_end; ++x) {
      if (picture.data[picture.index(x, y)] < 128) {
        return true;
      }
    }
  }
  return false;
}

TEST(TextPainter, InksItsOwnWidthAndNothingElse) {
  Expected<TextPainter> painter = TextPainter::load();
  ASSERT_TRUE(painter) << sentence(painter.error());
  const TextStyle style{.height_px = 20};
  ByteImage picture = white({400, 40});
  painter->draw(picture, 100, 28, "HIT 42 %", style);
  const int width = painter->widthOf("HIT 42 %", style);
  EXPECT_GT(width, 60);
  EXPECT_LT(width, 120);
  EXPECT_FALSE(hasInk(picture, 0, 99));
  EXPECT_TRUE(hasInk(picture, 100, 110));
  EXPECT_TRUE(hasInk(picture, 100 + width - 20, 100 + width));
  EXPECT_FALSE(hasInk(picture, 100 + width + 1, 400));
}

TEST(TextPainter, MovesOnForBlanksAndMarksWhatIsNotAscii) {
  Expected<TextPainter> painter = TextPainter::load();
  ASSERT_TRUE(painter) << sentence(painter.error());
  const TextStyle style{.height_px = 16};
  EXPECT_GT(painter->widthOf("a a", style), painter->widthOf("aa", style) + 2);
  EXPECT_EQ(painter->widthOf("2 ≤ µ", style), painter->widthOf("2 ? ?", style));
  EXPECT_GT(painter->widthOf("bold", {.height_px = 16, .weight = TextWeight::kBold}),
            painter->widthOf("bold", style));
}

TEST(TextPainter, CutsAtTheEdgesAndTakesBrokenUtf8) {
  Expected<TextPainter> painter = TextPainter::load();
  ASSERT_TRUE(painter) << sentence(painter.error());
  ByteImage picture = white({10, 10});
  for (const int x : {-1000, -5, 5, 1000}) {
    for (const int y : {-50, 0, 5, 12, 500}) {
      painter->draw(picture, x, y, "Wg\xff\xc3", {.height_px = 18});
    }
  }
  EXPECT_EQ(picture.data.size(), 300U);
}

}  // namespace
}  // namespace ssrkit
