#include "frame/pass_times.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TEST(PassTimes, TheFirstRoundIsColdAndTheLaterOnesAreSteady) {
  PassTimes times;
  for (const std::int64_t ns : {50, 7, 8}) {
    times.add("light", {.wall_ns = ns, .cpu_ns = 2 * ns});
    times.add("trace", {.wall_ns = ns + 1, .cpu_ns = 1});
    times.endRound();
  }
  ASSERT_EQ(times.reports().size(), 2U);
  EXPECT_EQ(times.reports()[0].pass, "light");
  EXPECT_EQ(times.reports()[0].cold.cpu_ns, 100);
  ASSERT_EQ(times.reports()[0].steady.size(), 2U);
  EXPECT_EQ(times.reports()[0].steady[1].wall_ns, 8);
  EXPECT_EQ(times.reports()[1].steady[0].wall_ns, 8);
}

TEST(PassTimes, SeveralDrawsOfOnePassInARoundAreTheirSum) {
  PassTimes times;
  times.add("trace", {.wall_ns = 3, .cpu_ns = 4, .device_ns = 5});
  times.add("trace", {.wall_ns = 30, .cpu_ns = 40, .device_ns = 50});
  times.endRound();
  ASSERT_EQ(times.reports().size(), 1U);
  EXPECT_EQ(times.reports()[0].cold.wall_ns, 33);
  EXPECT_EQ(times.reports()[0].cold.cpu_ns, 44);
  EXPECT_EQ(times.reports()[0].cold.device_ns, 55);
  EXPECT_TRUE(times.reports()[0].steady.empty());
}

TEST(PassTimes, ASumWithoutEveryTimestampHasNone) {
  PassTimes times;
  times.add("trace", {.wall_ns = 3, .cpu_ns = 4, .device_ns = 5});
  times.add("trace", {.wall_ns = 3, .cpu_ns = 4});
  times.endRound();
  EXPECT_FALSE(times.reports()[0].cold.device_ns.has_value());
}

}  // namespace
}  // namespace ssrkit
