#include "report/run_report.h"

#include <gtest/gtest.h>

#include <vector>

namespace ssrkit {
namespace {

PassTime timeOf(std::int64_t cpu_ns, std::int64_t wall_ns) {
  return {.wall_ns = wall_ns, .cpu_ns = cpu_ns, .device_ns = {}};
}

// 20 rays with 1, 2, ... 20 lookups, a masked and a background pixel: mean 10.5, p50 the 10th, p95 the 19th.
TEST(Summarise, CountsLookupsOnlyOfTracedRays) {
  RayRecord record{.size = {22, 1}, .rays = std::vector<RayHit>(22)};
  for (std::size_t i = 0; i < 20; ++i) {
    record.rays[i].ray_class = i < 5 ? RayClass::kHit : RayClass::kOffscreen;
    record.rays[i].lookups = static_cast<std::uint32_t>(20 - i);
  }
  record.rays[20].ray_class = RayClass::kMasked;
  record.rays[21].ray_class = RayClass::kBackground;
  const TraceSummary summary = summarise(record, {});
  EXPECT_EQ(summary.traced_rays, 20U);
  EXPECT_EQ(summary.lookups.mean, 10.5);
  EXPECT_EQ(summary.lookups.p50, 10.0);
  EXPECT_EQ(summary.lookups.p95, 19.0);
  EXPECT_EQ(summary.lookups.max, 20.0);
  EXPECT_EQ(summary.classes, (std::array<std::size_t, kRayClassCount>{1, 1, 5, 15, 0, 0, 0}));
  EXPECT_FALSE(summary.verdicts);
}

TEST(Summarise, CountsARayOfNoClassInNone) {
  RayRecord record{.size = {2, 1}, .rays = std::vector<RayHit>(2)};
  record.rays[0].ray_class = static_cast<RayClass>(200);
  const TraceSummary summary = summarise(record, {});
  EXPECT_EQ(summary.classes, (std::array<std::size_t, kRayClassCount>{1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(summary.traced_rays, 1U);
}

TEST(Summarise, HasNoLookupsWithoutRays) {
  const TraceSummary summary = summarise({.size = {1, 1}, .rays = std::vector<RayHit>(1)}, {});
  EXPECT_EQ(summary.traced_rays, 0U);
  EXPECT_EQ(summary.lookups.max, 0.0);
}

TEST(SameFraction, LeavesOutPixelsWithoutARay) {
  const std::vector<Verdict> verdicts = {Verdict::kNone, Verdict::kNone, Verdict::kSame,
                                         Verdict::kSame, Verdict::kSame, Verdict::kAmbiguous};
  EXPECT_EQ(sameFraction(countVerdicts(verdicts)), 0.75);
  EXPECT_EQ(sameFraction(countVerdicts(std::vector<Verdict>{Verdict::kNone})), std::nullopt);
}

TEST(TraceCost, SumsTheMediansOfPyramidAndTrace) {
  const std::vector<PassReport> passes = {
      {"pyramid", timeOf(900, 900), {timeOf(1'000'000, 2'000'000), timeOf(3'000'000, 2'000'000)}},
      {"trace",
       timeOf(900, 900),
       {timeOf(5'000'000, 7'000'000), timeOf(9'000'000, 1'000'000), timeOf(4'000'000, 8'000'000)}},
      {"resolve", timeOf(50'000'000, 50'000'000), {}}};
  const auto cost = traceCost(passes);
  ASSERT_TRUE(cost);
  EXPECT_DOUBLE_EQ(cost->cpu_ms, 2.0 + 5.0);
  EXPECT_DOUBLE_EQ(cost->wall_ms, 2.0 + 7.0);
}

TEST(TraceCost, TakesTheColdTimeWithoutRoundsAndNothingWithoutATrace) {
  const std::vector<PassReport> cold = {{"trace", timeOf(1'500'000, 2'500'000), {}}};
  EXPECT_DOUBLE_EQ(traceCost(cold)->cpu_ms, 1.5);
  EXPECT_FALSE(traceCost(std::vector<PassReport>{{"resolve", timeOf(1, 1), {}}}));
}

}  // namespace
}  // namespace ssrkit
