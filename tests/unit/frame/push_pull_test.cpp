// Hole filling: what is known stays, holes take the nearest known colours and no others.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "pass_test.h"

namespace ssrkit {
namespace {

using Texel = std::array<double, 4>;
using TexelAt = std::function<Texel(int x, int y)>;

Texel miss(int /*x*/, int /*y*/) {
  return {-1, -1};
}

class PushPullTest : public PassTest {
 protected:
  // Fills the holes (alpha 0) of an image; texels where `mask` is 0 reflect nothing.
  Image fill(
      const std::string& shader, const Image& reflection, int fill_levels,
      const std::function<double(int x, int y)>& mask = [](int, int) { return 1.0; },
      const TexelAt& hit = miss, const TexelAt& lit = miss) {
    begin();
    const Size size = reflection.size;
    drawMips("pull.frag", reflection, Format::kRgba16f, "known");
    values_.set("size_px", glm::dvec2(size.width, size.height));
    values_.set("fill_levels", fill_levels);
    give("reflection", reflection, Format::kRgba16f);
    give("material", imageOf(size, [&](int x, int y) { return Texel{1.0, 0.0, mask(x, y), 1.0}; }));
    give("dist_view",
         imageOf(
             size, [](int, int) { return Texel{3.0}; }, 1),
         Format::kR32f);
    giveIntegers("hit_texel", imageOf(size, hit, 2), Format::kRg16i);
    give("lit", imageOf(size, lit));
    return draw(shader, size, Format::kRgba16f);
  }
};

const std::vector<Size> kFilledSizes = {{1, 1}, {3, 3}, {127, 63}, {161, 91}};

TEST_P(PushPullTest, KnownPixelsKeepTheirBitsAtOddSizes) {
  for (const Size& size : kFilledSizes) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Image reflection = imageOf(size, [&](int, int) {
      return unit(random) < 0.4 ? Texel{} : Texel{4.0 * unit(random), unit(random), unit(random), 1.0};
    });
    give("source", reflection, Format::kRgba16f);
    const Image stored = draw("copy.frag", size, Format::kRgba16f);
    const Image filled = fill("push.frag", reflection, 8);
    for (std::size_t i = 0; i < filled.data.size(); ++i) {
      if (reflection.data[i / 4 * 4 + 3] > 0.0F) {
        ASSERT_EQ(filled.data[i], stored.data[i]) << size.width << "x" << size.height << " value " << i;
      }
    }
  }
}

TEST_P(PushPullTest, AConstantStaysItselfBitForBitAtOddSizes) {
  const Texel constant{0.7998046875, 3.30078125, 0.125, 1.0};
  for (const Size& size : kFilledSizes) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Image reflection =
        imageOf(size, [&](int x, int y) { return x + y > 0 && unit(random) < 0.25 ? Texel{} : constant; });
    const Image filled = fill("push.frag", reflection, 5);
    for (std::size_t i = 0; i < filled.data.size(); i += 4) {
      ASSERT_GT(filled.data[i + 3], 0.0F) << size.width << "x" << size.height << " texel " << i / 4;
      ASSERT_EQ(filled.data[i], 0.7998046875F) << size.width << "x" << size.height << " texel " << i / 4;
      ASSERT_EQ(filled.data[i + 1], 3.30078125F);
      ASSERT_EQ(filled.data[i + 2], 0.125F);
    }
  }
}

TEST_P(PushPullTest, ASmallHoleTakesItsNeighboursAndNothingFarther) {
  // Red on the left, blue on the right; a hole of one pixel deep in either.
  const Size size{161, 91};
  const auto is_hole = [](int x, int y) { return (x == 20 || x == 140) && y == 40; };
  const auto colour = [](int x) { return x < 80 ? Texel{1, 0, 0, 1} : Texel{0, 0, 1, 1}; };
  const Image filled =
      fill("push.frag", imageOf(size, [&](int x, int y) { return is_hole(x, y) ? Texel{} : colour(x); }), 6);
  for (const int x : {20, 140}) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(filled.at(x, 40, channel), static_cast<float>(colour(x)[channel]));
    }
  }
}

TEST_P(PushPullTest, AHoleBetweenTwoSurfacesMixesTheirColoursAndFetchesNoThird) {
  // The lit image: red at its left, green in its middle, blue at its right. Pixels left of the hole hit red,
  // right of it blue; nothing hits green.
  const Size size{64, 32};
  const auto lit = [](int x, int) {
    return x < 20 ? Texel{1, 0, 0, 1} : x < 44 ? Texel{0, 1, 0, 1} : Texel{0, 0, 1, 1};
  };
  const auto hit = [](int x, int y) {
    return x < 28   ? Texel{4.0, static_cast<double>(y)}
           : x < 36 ? Texel{-1, -1}
                    : Texel{60.0, static_cast<double>(y)};
  };
  const auto reflection = [&](int x, int y) {
    return hit(x, y)[0] < 0 ? Texel{} : lit(static_cast<int>(hit(x, y)[0]), y);
  };
  const auto check = [&](const std::string& shader) -> std::string {
    const Image filled = fill(
        shader, imageOf(size, reflection), 6, [](int, int) { return 1.0; }, hit, lit);
    for (int x = 0; x < size.width; ++x) {
      if (filled.at(x, 16, 1) != 0.0F) {
        return fmt::format("green {} at column {}", filled.at(x, 16, 1), x);
      }
      const float sum = filled.at(x, 16, 0) + filled.at(x, 16, 2);
      if (std::abs(sum - 1.0F) > 1e-3F) {
        return fmt::format("red and blue sum to {} at column {}", sum, x);
      }
    }
    return "";
  };
  holdsAndKills(check, "push.frag", {"fill_averages_hits"});
}

// The pull in double precision: means over each texel's area, colours weighed by alpha.
Image pulled(const Image& finer) {
  const Size size{std::max(1, finer.size.width / 2), std::max(1, finer.size.height / 2)};
  const double width = static_cast<double>(finer.size.width) / size.width;
  const double height = static_cast<double>(finer.size.height) / size.height;
  return imageOf(size, [&](int x, int y) {
    Texel sum{};
    for (int fine_y = 0; fine_y < finer.size.height; ++fine_y) {
      const double tall = std::min((y + 1) * height, fine_y + 1.0) - std::max(y * height, fine_y + 0.0);
      for (int fine_x = 0; tall > 1e-9 && fine_x < finer.size.width; ++fine_x) {
        const double wide = std::min((x + 1) * width, fine_x + 1.0) - std::max(x * width, fine_x + 0.0);
        const double alpha = std::max(wide, 0.0) * tall * static_cast<double>(finer.at(fine_x, fine_y, 3));
        sum[3] += alpha;
        for (std::size_t channel = 0; channel < 3; ++channel) {
          sum[channel] += alpha * static_cast<double>(finer.at(fine_x, fine_y, channel));
        }
      }
    }
    return sum[3] > 0.0 ? Texel{sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], sum[3] / (width * height)}
                        : Texel{};
  });
}

// One hole in double precision: bilinear weights on ever coarser mips, until they sum to 1.
Texel filledHole(const std::vector<Image>& mips, double u, double v) {
  Texel sum{};
  double weight = 0.0;
  double known_around = 0.0;
  for (std::size_t mip = 1; mip < mips.size(); ++mip) {
    const Image& known = mips[mip];
    const double at_x = u * known.size.width - 0.5;
    const double at_y = v * known.size.height - 0.5;
    const double left = weight < 0.999 ? 1.0 - weight : 0.0;
    known_around = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const double column = std::floor(at_x + 1e-9) + corner % 2;
      const double row = std::floor(at_y + 1e-9) + (corner < 2 ? 0 : 1);
      const double near = (1.0 - std::abs(at_x - column)) * (1.0 - std::abs(at_y - row));
      const int x = std::clamp(static_cast<int>(column), 0, known.size.width - 1);
      const int y = std::clamp(static_cast<int>(row), 0, known.size.height - 1);
      const auto alpha = static_cast<double>(known.at(x, y, 3));
      known_around += near * alpha;
      weight += alpha > 0.0 ? left * near : 0.0;
      sum[3] += left * near * alpha;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        sum[channel] += left * near * alpha * static_cast<double>(known.at(x, y, channel));
      }
    }
  }
  const double alpha = (known_around - 9.0 / 16.0) / (7.0 / 16.0);
  return alpha > 0.0 ? Texel{sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], alpha} : Texel{};
}

TEST_P(PushPullTest, EachHoleIsFilledFromTheFinestMipsThatReachIt) {
  const Size size{161, 91};
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Image reflection = imageOf(size, [&](int x, int y) {
    const bool is_large_hole = std::hypot(x - 70.0, y - 40.0) < 20.0;
    return is_large_hole || unit(random) < 0.5
               ? Texel{}
               : Texel{unit(random), unit(random), 0.5, 0.6 + 0.4 * unit(random)};
  });
  std::vector<Image> mips = {reflection};
  for (int mip = 1; mip <= 5; ++mip) {
    mips.push_back(pulled(mips.back()));
  }
  const Image expected = imageOf(size, [&](int x, int y) {
    return reflection.at(x, y, 3) > 0.0F
               ? Texel{reflection.at(x, y, 0), reflection.at(x, y, 1), 0.5, reflection.at(x, y, 3)}
               : filledHole(mips, (x + 0.5) / size.width, (y + 0.5) / size.height);
  });
  // Halves hold 11 bits, and the mips are stored in them too.
  EXPECT_GT(std::ranges::count(expected.data, 0.0F), 1000);
  EXPECT_EQ(difference(fill("push.frag", reflection, 5), expected, 3e-3), "");
}

TEST_P(PushPullTest, BesideAStraightEdgeNothingIsFilled) {
  // What is reflected ends at each column of a cell of the coarsest mip in turn; what lies beyond is no hole.
  const Size size{160, 96};
  for (int edge = 64; edge < 96; ++edge) {
    const Image filled = fill("push.frag",
                              imageOf(size,
                                      [&](int x, int) {
                                        return x < edge ? Texel{1, 1, 1, 1} : Texel{};
                                      }),
                              5);
    for (int x = edge; x < size.width; ++x) {
      ASSERT_EQ(filled.at(x, 48, 3), 0.0F) << "edge " << edge << " column " << x;
    }
  }
}

TEST_P(PushPullTest, AHolesAlphaFallsWithItsWidth) {
  const Size size{160, 96};
  float last = 1.0F;
  for (const int radius : {1, 4, 8, 12, 16}) {
    const Image filled =
        fill("push.frag",
             imageOf(size,
                     [&](int x, int y) {
                       return std::hypot(x - 79.5, y - 47.5) < radius ? Texel{} : Texel{1, 1, 1, 1};
                     }),
             5);
    EXPECT_LT(filled.at(80, 48, 3), last) << radius;
    EXPECT_GT(filled.at(80, 48, 3), radius < 8 ? 0.8F : -1.0F) << radius;
    last = filled.at(80, 48, 3);
  }
}

TEST_P(PushPullTest, WhatReflectsNothingIsNotFilled) {
  const Size size{64, 32};
  const Image filled = fill("push.frag",
                            imageOf(size,
                                    [](int x, int) {
                                      return x == 30 ? Texel{} : Texel{1, 1, 1, 1};
                                    }),
                            3, [](int, int y) { return y < 16 ? 1.0 : 0.0; });
  EXPECT_GT(filled.at(30, 10, 3), 0.0F);
  EXPECT_EQ(filled.at(30, 20, 3), 0.0F);
}

INSTANTIATE_TEST_SUITE_P(Each, PushPullTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
