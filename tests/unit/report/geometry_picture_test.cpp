#include "report/geometry_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace ssrkit {
namespace {

TEST(GeometryPicture, ColoursRaysAndShowsThePictureElsewhere) {
  GeometryResult geometry({3, 1});
  geometry.setRow(0, std::array<TrueRay, 3>{TrueRay{.true_class = TrueClass::kNone},
                                            TrueRay{.true_class = TrueClass::kOccluded},
                                            TrueRay{.true_class = TrueClass::kSky}});
  Image lit({3, 1}, {"R", "G", "B"});
  std::ranges::fill(lit.data, 1.0F);
  const ByteImage picture = geometryPicture(geometry, lit);
  const auto colourAt = [&](int x) {
    const std::size_t first = picture.index(x, 0);
    return Rgb8{picture.data[first], picture.data[first + 1], picture.data[first + 2]};
  };
  EXPECT_EQ(colourAt(0), (Rgb8{255, 255, 255}));
  EXPECT_EQ(colourAt(1), (Rgb8{213, 94, 0}));
  EXPECT_EQ(colourAt(2), (Rgb8{86, 180, 233}));
}

TEST(GeometryPicture, GivesEveryClassAColourOfItsOwn) {
  std::set<Rgb8> colours;
  for (int i = 0; i < kTrueClassCount; ++i) {
    colours.insert(colourOf(static_cast<TrueClass>(i)));
  }
  EXPECT_EQ(colours.size(), static_cast<std::size_t>(kTrueClassCount));
}

}  // namespace
}  // namespace ssrkit
