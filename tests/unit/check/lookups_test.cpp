#include <gtest/gtest.h>

#include <algorithm>

#include "made_answers.h"

namespace ssrkit {
namespace {

TEST(Lookups, MeanPercentileAndLargestLeaveMaskedPixelsOut) {
  Bench bench;
  RayRecord record{kMadeSize, std::vector<RayHit>(64, without(RayClass::kMasked))};
  for (std::size_t i = 0; i < 20; ++i) {
    record.rays[i] = hitAt(1, 1, i == 19 ? 105 : 5);
  }
  bench.add("hiz", record);
  const auto bound = [](const std::string& metric, const std::string& max) {
    return expectation("metric = \"" + metric + "\"\nmax = " + max);
  };
  EXPECT_EQ(bench.check(bound("mean_lookups", "10")).value, 10.0);
  EXPECT_EQ(outcomeName(bench.check(bound("mean_lookups", "10"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(bound("mean_lookups", "9.99"))), "fail");
  EXPECT_EQ(bench.check(bound("p95_lookups", "5")).value, 5.0);
  EXPECT_EQ(outcomeName(bench.check(bound("p95_lookups", "4"))), "fail");
  EXPECT_EQ(bench.check(bound("max_lookups", "105")).value, 105.0);
  EXPECT_EQ(outcomeName(bench.check(bound("max_lookups", "104"))), "fail");
}

TEST(Lookups, RatiosAndGrowthAreOfTheMeans) {
  Bench bench;
  const auto all = [](Size size, std::uint32_t lookups) {
    RayRecord record = shiftedRecord(size);
    std::ranges::for_each(record.rays, [&](RayHit& ray) { ray.lookups = lookups; });
    return record;
  };
  bench.add("hiz", all(kMadeSize, 10));
  bench.add("walk", all(kMadeSize, 130));
  bench.add("hiz", all({16, 16}, 16));
  const auto ratio = [](const char* min) {
    return expectation(std::string("metric = \"lookup_ratio\"\ntruth = \"stage:walk\"\nmin = ") + min);
  };
  EXPECT_EQ(outcomeName(bench.check(ratio("13"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(ratio("13.1"))), "fail");
  const auto added = [](const char* max) {
    return expectation(std::string("metric = \"lookups_added\"\ntruth = \"size:8x8\"\nmax = ") + max);
  };
  EXPECT_EQ(outcomeName(bench.check(added("6"), 2)), "pass");
  EXPECT_EQ(outcomeName(bench.check(added("5.9"), 2)), "fail");
  bench.records.front() = all(kMadeSize, 0);  // a stage that counts nothing proves nothing
  EXPECT_EQ(outcomeName(bench.check(ratio("13"))), "error");
}

// 200 rays: as many hits as misses but for `misses`, at 10 lookups a hit and 25 a miss.
RayRecord hitsAndMisses(std::size_t misses) {
  RayRecord record = shiftedRecord({20, 10});
  for (std::size_t i = 0; i < misses; ++i) {
    record.rays[i] = without(i % 2 == 0 ? RayClass::kOffscreen : RayClass::kRange, 25);
  }
  return record;
}

TEST(MissLookupRatio, IsTheMeanOfMissesOverTheMeanOfHits) {
  Bench bench;
  bench.add("hiz", hitsAndMisses(100));
  const CheckResult check = bench.check(expectation("metric = \"miss_lookup_ratio\"\nmin = 2.5"));
  EXPECT_EQ(check.value, 2.5);
  EXPECT_EQ(outcomeName(check), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"miss_lookup_ratio\"\nmin = 2.6"))), "fail");
}

TEST(MissLookupRatio, CountsNoRayThatNeverStarted) {
  Bench bench;
  RayRecord record = hitsAndMisses(101);
  record.rays[0] = without(RayClass::kIntoSurface, 0);
  Answer& answer = bench.add("hiz", record);
  EXPECT_EQ(bench.check(expectation("metric = \"miss_lookup_ratio\"\nmin = 1")).compared, 199U)
      << answer.stage;
}

TEST(MissLookupRatio, SaysNothingByAHandfulOfRays) {
  Bench bench;
  bench.add("hiz", hitsAndMisses(3));
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"miss_lookup_ratio\"\nmin = 1"))), "inconclusive");
  Bench without_misses;
  without_misses.add("hiz", hitsAndMisses(0));
  EXPECT_EQ(outcomeName(without_misses.check(expectation("metric = \"miss_lookup_ratio\"\nmin = 1"))),
            "error");
}

TEST(P95LookupRatio, IsOfTheTwoPercentiles) {
  Bench bench;
  // 95 of 100 rays at 10 lookups and 5 at 900, against 40: the tail beyond the percentile does not count.
  RayRecord finite = shiftedRecord({10, 10});
  for (std::size_t i = 0; i < 5; ++i) {
    finite.rays[i].lookups = 900;
  }
  RayRecord infinite = shiftedRecord({10, 10});
  for (RayHit& ray : infinite.rays) {
    ray.lookups = 40;
  }
  bench.add("hiz", finite, "gl-osmesa", "t_0.3m");
  bench.add("hiz", infinite, "gl-osmesa", "t_inf");
  Expectation ratio = expectation("metric = \"mean_lookups\"\nmax = 2");
  ratio.metric = Metric::kP95LookupRatio;
  ratio.truth = {TruthKind::kCase, "t_inf"};
  EXPECT_EQ(bench.check(ratio).value, 0.25);
  ratio.max = 0.2;
  EXPECT_EQ(outcomeName(bench.check(ratio)), "fail");
}

}  // namespace
}  // namespace ssrkit
