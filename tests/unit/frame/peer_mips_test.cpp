// The mips of a peer's depth against the texels below them, whichever way the peer finds its cell.
#include <algorithm>
#include <functional>
#include <random>

#include "pass_test.h"

namespace ssrkit {
namespace {

class PeerMipsTest : public PassTest {
 protected:
  std::vector<Image> mipsOf(const Image& base, double sign) {
    begin();
    values_.set("peer_mips_sign", sign);
    return drawMips("peer_mips.frag", base, Format::kR32f);
  }
};

Image depths(Size size) {
  std::mt19937 random(size.width);
  std::uniform_real_distribution<float> depth(0.0F, 1.0F);
  return imageOf(
      size, [&](int, int) { return std::array<double, 4>{depth(random)}; }, 1);
}

// The least over the texels [x, x_end) by [y, y_end).
float leastOf(const Image& image, int x, int y, int x_end, int y_end) {
  float least = 1.0F;
  for (int row = y; row < y_end; ++row) {
    for (int column = x; column < x_end; ++column) {
      least = std::min(least, image.at(column, row));
    }
  }
  return least;
}

TEST_P(PeerMipsTest, AreTheLeastOfTheTexelsBelowAtPowersOfTwo) {
  const Image base = depths({16, 8});
  const std::vector<Image> mips = mipsOf(base, 1.0);
  ASSERT_EQ(mips.size(), 5);
  for (int level = 1; level < 4; ++level) {
    const int side = 1 << level;
    const Image& mip = mips[level];
    for (int y = 0; y < mip.size.height; ++y) {
      for (int x = 0; x < mip.size.width; ++x) {
        EXPECT_EQ(mip.at(x, y), leastOf(base, x * side, y * side, (x + 1) * side, (y + 1) * side));
      }
    }
  }
  EXPECT_EQ(mips[4].at(0, 0), leastOf(base, 0, 0, 16, 8));
}

TEST_P(PeerMipsTest, LeaveNothingOutAtOddSizesWhicheverWayACellIsFound) {
  for (const Size size : {Size{37, 23}, Size{5, 1}, Size{640 / 16, 360 / 8}}) {
    const Image base = depths(size);
    const std::vector<Image> mips = mipsOf(base, 1.0);
    for (int level = 1; level < static_cast<int>(mips.size()); ++level) {
      const auto [width, height] = mips[level].size;
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const float depth = base.at(x, y);
          EXPECT_LE(mips[level].at(std::min(x >> level, width - 1), std::min(y >> level, height - 1)), depth);
          EXPECT_LE(mips[level].at((2 * x + 1) * width / (2 * size.width),
                                   (2 * y + 1) * height / (2 * size.height)),
                    depth);
        }
      }
      // No more than the cell and, an odd row a level, as much again.
      const int side = 2 << level;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const int left = x << level;
          const int top = y << level;
          EXPECT_GE(mips[level].at(x, y), leastOf(base, left, top, std::min(left + side, size.width),
                                                  std::min(top + side, size.height)));
        }
      }
    }
  }
}

TEST_P(PeerMipsTest, AreTheGreatestWithTheOtherSign) {
  const Image base = depths({7, 5});
  Image negated = base;
  std::ranges::transform(negated.data, negated.data.begin(), std::negate<>());
  const std::vector<Image> greatest = mipsOf(base, -1.0);
  const std::vector<Image> least = mipsOf(negated, 1.0);
  for (std::size_t level = 1; level < least.size(); ++level) {
    for (std::size_t i = 0; i < least[level].data.size(); ++i) {
      EXPECT_EQ(greatest[level].data[i], -least[level].data[i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PeerMipsTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
