#include "image/colour_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ssrkit {
namespace {

double decoded(std::uint8_t byte) {
  const double encoded = byte / 255.0;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// CIE relative luminance of sRGB (IEC 61966-2-1).
double luminance(Rgb8 colour) {
  return 0.2126 * decoded(colour[0]) + 0.7152 * decoded(colour[1]) + 0.0722 * decoded(colour[2]);
}

TEST(SequentialColour, RunsFromViridisPurpleToYellow) {
  EXPECT_EQ(sequentialColour(0.0), (Rgb8{68, 1, 84}));
  EXPECT_EQ(sequentialColour(0.5), (Rgb8{33, 145, 140}));
  EXPECT_EQ(sequentialColour(1.0), (Rgb8{253, 231, 37}));
}

TEST(SequentialColour, ClampsAndTakesNan) {
  EXPECT_EQ(sequentialColour(-1.0), sequentialColour(0.0));
  EXPECT_EQ(sequentialColour(std::numeric_limits<double>::infinity()), sequentialColour(1.0));
  EXPECT_EQ(sequentialColour(std::nan("")), sequentialColour(0.0));
}

TEST(SequentialColour, GetsLighterAllTheWaySoThatGreyscaleReadersSeeTheOrder) {
  for (int i = 0; i < 100; ++i) {
    EXPECT_LT(luminance(sequentialColour(i / 100.0)), luminance(sequentialColour((i + 1) / 100.0))) << i;
  }
}

TEST(ColourOf, TellsAllRayClassesApart) {
  for (int a = 0; a < kRayClassCount; ++a) {
    for (int b = 0; b < a; ++b) {
      const Rgb8 first = colourOf(static_cast<RayClass>(a));
      const Rgb8 second = colourOf(static_cast<RayClass>(b));
      int distance = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        distance += std::abs(first[i] - second[i]);
      }
      EXPECT_GE(distance, 90) << name(static_cast<RayClass>(a)) << " and " << name(static_cast<RayClass>(b));
    }
  }
}

// Values of the standard's own curve: 50 % grey is about 0.7354, 18 % grey about 0.4614.
TEST(SrgbEncode, IsTheStandardCurve) {
  EXPECT_DOUBLE_EQ(srgbEncode(0.0), 0.0);
  EXPECT_NEAR(srgbEncode(1.0), 1.0, 1e-12);
  EXPECT_NEAR(srgbEncode(0.5), 0.735357, 1e-6);
  EXPECT_NEAR(srgbEncode(0.18), 0.461356, 1e-6);
  EXPECT_NEAR(srgbEncode(0.001), 0.01292, 1e-12);
}

TEST(ToneMap, RoundsTripEveryByte) {
  Image image({256, 1}, {"R", "G", "B"});
  for (int x = 0; x < 256; ++x) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      image.at(x, 0, channel) = static_cast<float>(decoded(static_cast<std::uint8_t>(x)));
    }
  }
  const ByteImage picture = toneMap(image);
  for (std::size_t i = 0; i < picture.data.size(); ++i) {
    EXPECT_EQ(picture.data[i], i / 3);
  }
}

TEST(ToneMap, ExposesClampsAndShowsNanInMagenta) {
  Image image({4, 1}, {"Y"});
  image.data = {0.25F, -1.0F, std::numeric_limits<float>::infinity(), std::nanf("")};
  const ByteImage picture = toneMap(image, 2.0);
  const std::array<std::uint8_t, 12> expected = {188, 188, 188, 0, 0, 0, 255, 255, 255, 255, 0, 255};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), picture.data.begin(), picture.data.end()));
}

}  // namespace
}  // namespace ssrkit
