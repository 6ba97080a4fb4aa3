#include "report/heat_scale.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace ssrkit {
namespace {

RayRecord recordOf(const std::vector<std::uint32_t>& lookups) {
  RayRecord record{.size = {static_cast<int>(lookups.size()), 1},
                   .rays = std::vector<RayHit>(lookups.size())};
  for (std::size_t i = 0; i < lookups.size(); ++i) {
    record.rays[i].lookups = lookups[i];
  }
  return record;
}

TEST(HeatScale, RoundsOutwardsToOneTwoFive) {
  const RayRecord few = recordOf({0, 7, 30});
  const RayRecord many = recordOf({12, 640});
  const HeatScale scale(std::array{&few, &many});
  EXPECT_EQ(scale.low(), 5.0);
  EXPECT_EQ(scale.high(), 1000.0);
  EXPECT_EQ(scale.ticks(), (std::vector<double>{5, 10, 20, 50, 100, 200, 500, 1000}));
}

TEST(HeatScale, IsLogarithmicAndClamped) {
  const RayRecord record = recordOf({1, 10000});
  const HeatScale scale(std::array{&record});
  EXPECT_DOUBLE_EQ(scale.placeOf(100), 0.5);
  EXPECT_EQ(scale.placeOf(0), 0.0);
  EXPECT_EQ(scale.placeOf(1e9), 1.0);
}

TEST(HeatScale, HasARangeEvenWhenAllCountsAreEqualOrThereAreNone) {
  for (const std::uint32_t count : {0U, 1U, 2U, 10U, 4294967295U}) {
    const RayRecord record = recordOf({count, count});
    const HeatScale scale(std::array{&record});
    EXPECT_LT(scale.low(), scale.high()) << count;
    EXPECT_GE(scale.low(), 1.0) << count;
    EXPECT_LE(scale.low(), std::max(count, 1U)) << count;
    EXPECT_GE(scale.high(), count) << count;
  }
}

}  // namespace
}  // namespace ssrkit
