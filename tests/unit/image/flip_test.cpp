#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "image/separable_filter.h"

namespace ssrkit {
namespace {

constexpr Size kSize{24, 20};

Image picture(float red, float green, float blue) {
  Image image(kSize, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.data.size(); i += 3) {
    image.data[i] = red;
    image.data[i + 1] = green;
    image.data[i + 2] = blue;
  }
  return image;
}

void set(Image& image, int x, int y, std::array<float, 3> colour) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    image.at(x, y, channel) = colour[channel];
  }
}

// Red and green rise, blue is a pattern.
Image ramp() {
  Image image(kSize, {"R", "G", "B"});
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      set(image, x, y,
          {static_cast<float>(x) / 24.0F, static_cast<float>(y) / 20.0F,
           static_cast<float>(x * y % 7) / 7.0F});
    }
  }
  return image;
}

// The ramp with a bright square and a dark line.
Image rampWithThings() {
  Image image = ramp();
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (x >= 5 && x < 9 && y >= 6 && y < 11) {
        set(image, x, y, {1.0F, 0.9F, 0.2F});
      } else if (x == 17) {
        set(image, x, y, {0.0F, 0.0F, 0.0F});
      }
    }
  }
  return image;
}

double mean(const Image& map) {
  return std::accumulate(map.data.begin(), map.data.end(), 0.0) / static_cast<double>(map.data.size());
}

// Of a program of its own, with the paper's kernels as whole two-dimensional tables and no separation.
TEST(Flip, GivesThePapersNumbers) {
  const Image map = flipMap(ramp(), rampWithThings());
  struct Expected {
    int x;
    int y;
    double flip;
  };
  for (const Expected& expected :
       {Expected{0, 0, 0.012847}, Expected{6, 8, 0.867077}, Expected{9, 8, 0.619108},
        Expected{17, 3, 0.567750}, Expected{18, 12, 0.395770}, Expected{23, 19, 0.076999},
        Expected{12, 10, 0.142521}}) {
    EXPECT_NEAR(map.at(expected.x, expected.y), expected.flip, 2e-5) << expected.x << " " << expected.y;
  }
  EXPECT_NEAR(mean(map), 0.222345, 1e-5);
}

TEST(Flip, IsZeroForTheSamePictureAndNearOneBetweenBlackAndWhite) {
  EXPECT_EQ(mean(flipMap(rampWithThings(), rampWithThings())), 0.0);
  const Image map = flipMap(picture(0.0F, 0.0F, 0.0F), picture(1.0F, 1.0F, 1.0F));
  EXPECT_NEAR(map.at(5, 5), 0.967380, 2e-5);
}

TEST(Flip, DoesNotCareWhichPictureIsTheReference) {
  const Image there = flipMap(ramp(), rampWithThings());
  const Image back = flipMap(rampWithThings(), ramp());
  EXPECT_EQ(there.data, back.data);
}

TEST(Flip, SeesLessFromFurtherAway) {
  Image spot = picture(0.5F, 0.5F, 0.5F);
  set(spot, 12, 10, {0.8F, 0.8F, 0.8F});
  const Image grey = picture(0.5F, 0.5F, 0.5F);
  const auto seenAt = [&](double pixels_per_degree) {
    return static_cast<double>(flipMap(grey, spot, pixels_per_degree).at(12, 10));
  };
  EXPECT_GT(seenAt(20.0), seenAt(40.0));
  EXPECT_GT(seenAt(40.0), seenAt(80.0));
  EXPECT_GT(seenAt(80.0), 0.0);
}

TEST(Flip, ClampsAsAScreenDoes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(mean(flipMap(picture(1.0F, 1.0F, 1.0F), picture(infinity, 40.0F, 1.0F))), 0.0);
  EXPECT_EQ(mean(flipMap(picture(0.0F, 0.0F, 0.0F), picture(nan, -3.0F, -infinity))), 0.0);
}

TEST(Flip, TakesOneChannelAsGrey) {
  Image dark(kSize, {"v"});
  Image light(kSize, {"v"});
  std::ranges::fill(light.data, 1.0F);
  EXPECT_NEAR(flipMap(dark, light).at(3, 3), 0.967380, 2e-5);
}

TEST(SeparableFilter, RepeatsTheBorderAndKeepsTheSides) {
  const Plane plane{{3, 1}, {1.0F, 2.0F, 4.0F}};
  const Kernel right = {{0.0, 0.0, 1.0}};  // what lies to the right
  const Kernel keep = {{1.0}};
  EXPECT_EQ(filtered(plane, right, keep).data, (std::vector<float>{2.0F, 4.0F, 4.0F}));
  const Plane tall{{1, 3}, {1.0F, 2.0F, 4.0F}};
  EXPECT_EQ(filtered(tall, keep, right).data, (std::vector<float>{2.0F, 4.0F, 4.0F}));
  EXPECT_EQ(filtered(tall, right, keep).data, tall.data);
}

}  // namespace
}  // namespace ssrkit
