#include "report/sheet_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "report/verdict_colours.h"

namespace ssrkit {
namespace {

Rgb8 dot(const ByteImage& picture, int x, int y) {
  const std::size_t at = picture.index(x, y);
  return {picture.data[at], picture.data[at + 1], picture.data[at + 2]};
}

TEST(CellScale, ShrinksByWholeFactorsAndGrowsAtMostFourTimes) {
  EXPECT_EQ(cellScaleFor({640, 360}).cell(), (Size{320, 180}));
  EXPECT_EQ(cellScaleFor({641, 361}).cell(), (Size{214, 121}));
  EXPECT_EQ(cellScaleFor({320, 180}).cell(), (Size{320, 180}));
  EXPECT_EQ(cellScaleFor({150, 100}).cell(), (Size{300, 200}));
  EXPECT_EQ(cellScaleFor({8, 4}).cell(), (Size{32, 16}));
  EXPECT_EQ(cellScaleFor({1, 16384}).cell(), (Size{1, 316}));
}

// The mean of linear 0 and 1 is linear 0.5, byte 188; the mean of the encoded bytes would be 128.
TEST(LightPicture, AveragesLinearLightNotBytes) {
  Image linear({640, 2}, {"R", "G", "B"});
  for (int x = 0; x < 640; x += 2) {
    for (int y = 0; y < 2; ++y) {
      linear.at(x, y, 0) = 1.0F;
    }
  }
  const ByteImage picture = lightPicture(linear, cellScaleFor(linear.size), 1.0);
  EXPECT_EQ(picture.size, (Size{320, 1}));
  EXPECT_EQ(dot(picture, 17, 0), (Rgb8{188, 0, 0}));
}

TEST(LightPicture, AveragesOnlyTheTexelsThereAreInTheLastBox) {
  Image linear({321, 1}, {"Y"});
  std::ranges::fill(linear.data, 0.5F);
  const ByteImage picture = lightPicture(linear, cellScaleFor(linear.size), 1.0);
  EXPECT_EQ(picture.size.width, 161);
  EXPECT_EQ(dot(picture, 160, 0), (Rgb8{188, 188, 188}));
}

TEST(VerdictPicture, KeepsASingleWrongRayAmongThousandsVisible) {
  const Size size{1280, 640};
  const CellScale scale = cellScaleFor(size);
  std::vector<Verdict> verdicts(std::size_t{1280} * 640, Verdict::kSame);
  verdicts[std::size_t{401} * 1280 + 803] = Verdict::kFalseHit;
  const ByteImage backdrop(scale.picture, 3);
  const ByteImage picture = verdictPicture(verdicts, size, scale, backdrop);
  EXPECT_EQ(dot(picture, 803 / 4, 401 / 4), colourOf(Verdict::kFalseHit));
  EXPECT_EQ(dot(picture, 803 / 4 + 1, 401 / 4), (Rgb8{0, 79, 58}));  // half of SAME's green
}

TEST(VerdictPicture, ShowsTheBackdropWhereThereIsNoRay) {
  ByteImage backdrop({2, 1}, 3);
  std::ranges::fill(backdrop.data, std::uint8_t{77});
  const std::vector<Verdict> verdicts = {Verdict::kNone, Verdict::kLeak};
  const CellScale scale{1, 1, {2, 1}};
  const ByteImage picture = verdictPicture(verdicts, {2, 1}, scale, backdrop);
  EXPECT_EQ(dot(picture, 0, 0), (Rgb8{77, 77, 77}));
  EXPECT_EQ(dot(picture, 1, 0), colourOf(Verdict::kLeak));
}

TEST(HeatPicture, AveragesTracedRaysOnly) {
  RayRecord record{.size = {640, 1}, .rays = std::vector<RayHit>(640)};
  record.rays[0].ray_class = RayClass::kHit;  // beside a masked pixel in the same box
  record.rays[0].lookups = 100;
  record.rays[2].ray_class = RayClass::kHit;
  record.rays[2].lookups = 20;
  record.rays[3].ray_class = RayClass::kOffscreen;
  record.rays[3].lookups = 30;
  const HeatScale heat(std::array<const RayRecord*, 1>{&record});
  const CellScale scale = cellScaleFor(record.size);
  ByteImage backdrop(scale.picture, 3);
  const ByteImage picture = heatPicture(record, scale, heat, backdrop);
  EXPECT_EQ(dot(picture, 0, 0), heat.colourOf(100));
  EXPECT_EQ(dot(picture, 1, 0), heat.colourOf(25));
  EXPECT_EQ(dot(picture, 2, 0), (Rgb8{0, 0, 0}));
}

}  // namespace
}  // namespace ssrkit
