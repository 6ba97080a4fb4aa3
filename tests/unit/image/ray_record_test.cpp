#include "image/ray_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace ssrkit {
namespace {

RayRecord oneHitAndOneMiss() {
  RayRecord record;
  record.size = {2, 1};
  record.rays = {RayHit{1, 0, 1.25F, 0.5F, 3.5F, RayClass::kHit, 16777216, 12},
                 RayHit{-1, -1, -1.0F, -1.0F, -1.0F, RayClass::kIntoSurface, 0, 0}};
  return record;
}

Image withValue(std::size_t channel, float value) {
  Image image = toImage(oneHitAndOneMiss());
  image.at(0, 0, channel) = value;
  return image;
}

TEST(ToImage, PutsEachFieldIntoTheChannelOfTheFileFormat) {
  const Image image = toImage(oneHitAndOneMiss());
  EXPECT_EQ(image.channels, (std::vector<std::string>{"texel.x", "texel.y", "px.x", "px.y", "t_m", "class",
                                                      "lookups", "steps"}));
  EXPECT_EQ(image.data, (std::vector<float>{1, 0, 1.25F, 0.5F, 3.5F, 2, 16777216, 12,  //
                                            -1, -1, -1, -1, -1, 6, 0, 0}));
}

TEST(RayRecordFromImage, ReadsChannelsByNameAndIgnoresOthers) {
  Image image({1, 1}, {"steps", "lookups", "extra", "class", "t_m", "px.y", "px.x", "texel.y", "texel.x"});
  image.data = {9, 8, 77, 2, 0.5F, 0.25F, 0.75F, 0, 0};
  const Expected<RayRecord> record = rayRecordFromImage(image, "hit.exr");
  ASSERT_TRUE(record) << sentence(record.error());
  const RayHit& ray = record->at(0, 0);
  EXPECT_EQ(ray.texel_x, 0);
  EXPECT_EQ(ray.px_x, 0.75F);
  EXPECT_EQ(ray.px_y, 0.25F);
  EXPECT_EQ(ray.t_m, 0.5F);
  EXPECT_EQ(ray.ray_class, RayClass::kHit);
  EXPECT_EQ(ray.lookups, 8U);
  EXPECT_EQ(ray.steps, 9U);
}

TEST(RayRecordFromImage, NamesAMissingChannel) {
  const Expected<RayRecord> record = rayRecordFromImage(Image({1, 1}, {"R", "G"}), "out/hit.exr");
  ASSERT_FALSE(record);
  EXPECT_NE(sentence(record.error()).find("out/hit.exr: "), std::string::npos);
  EXPECT_NE(sentence(record.error()).find("the channel 'texel.x' is missing; it holds R and G"),
            std::string::npos);
}

TEST(RayRecordFromImage, RefusesValuesThatTheirChannelMayNotHold) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const std::vector<std::pair<std::size_t, float>> bad = {
      {0, 2}, {0, -2}, {0, 0.5F}, {0, kNan}, {1, 1},          {1, 1e30F}, {2, kNan},  {3, kInf}, {4, kNan},
      {5, 7}, {5, -1}, {5, 1.5F}, {6, -1},   {6, 1.67773e7F}, {6, kNan},  {7, 0.25F}, {7, kInf}};
  for (const auto& [channel, value] : bad) {
    const Expected<RayRecord> record = rayRecordFromImage(withValue(channel, value), "hit.exr");
    ASSERT_FALSE(record) << "channel " << channel << " = " << value;
    EXPECT_NE(record.error().problem.find("at texel (0, 0)"), std::string::npos) << record.error().problem;
  }
}

TEST(RayRecordFromImage, RefusesAHitWithoutATexelAndAMissWithOne) {
  EXPECT_FALSE(rayRecordFromImage(withValue(5, 3), "hit.exr"));   // OFFSCREEN with texel (1, 0)
  EXPECT_FALSE(rayRecordFromImage(withValue(0, -1), "hit.exr"));  // HIT with texel (-1, 0)
}

TEST(RayClassName, IsTheWordOfTheFileFormat) {
  EXPECT_STREQ(name(RayClass::kMasked), "MASKED");
  EXPECT_STREQ(name(RayClass::kHit), "HIT");
  EXPECT_STREQ(name(RayClass::kIntoSurface), "INTO_SURFACE");
}

}  // namespace
}  // namespace ssrkit
