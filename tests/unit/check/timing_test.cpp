// The metrics of time, over made samples.
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "made_answers.h"

namespace ssrkit {
namespace {

std::vector<TimeSample> samples(std::span<const double> cpu_ns) {
  std::vector<TimeSample> made;
  for (const double ns : cpu_ns) {
    made.push_back({ns, ns});
  }
  return made;
}

TEST(CpuRatio, PassesAreSummedAndHeldAgainstTheOtherStage) {
  Bench bench;
  const std::vector<double> ten(15, 10.0);
  const std::vector<double> hundred(15, 100.0);
  bench.add("hiz", shiftedRecord({8, 8})).times = {{"trace", samples(ten)}, {"pyramid", samples(ten)}};
  bench.add("walk", shiftedRecord({8, 8})).times = {{"trace", samples(hundred)},
                                                    {"pyramid", samples(hundred)}};
  const std::string stage = "metric = \"cpu_ratio\"\nstages = [\"hiz\"]\ntruth = \"stage:walk\"\n";
  EXPECT_EQ(outcomeName(bench.check(expectation(stage + "max = 0.1"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation(stage + "max = 0.09"))), "fail");
  // Two passes of 10 over the other's one of 100.
  const std::string sum = stage + "passes = [\"trace\", \"pyramid\"]\nover = [\"trace\"]\n";
  EXPECT_EQ(outcomeName(bench.check(expectation(sum + "max = 0.2"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation(sum + "max = 0.18"))), "fail");
  const std::string share = "metric = \"pass_cpu_share\"\npasses = [\"pyramid\"]\nover = [\"trace\"]\n";
  EXPECT_EQ(outcomeName(bench.check(expectation(share + "max = 1.0"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation(share + "max = 0.9"))), "fail");
  bench.answers[1].times.clear();
  EXPECT_EQ(outcomeName(bench.check(expectation(stage + "max = 0.1"))), "error");
}

TEST(CpuRatio, TooFewRoundsAreInconclusiveAndUnequalOnesAnError) {
  Bench bench;
  const std::vector<double> few(5, 1.0);
  const std::vector<double> more(9, 1.0);
  bench.add("hiz", shiftedRecord({8, 8})).times = {{"trace", samples(few)}};
  bench.add("walk", shiftedRecord({8, 8})).times = {{"trace", samples(few)}};
  const Expectation ratio = expectation("metric = \"cpu_ratio\"\ntruth = \"stage:walk\"\nmax = 2.0");
  EXPECT_EQ(outcomeName(bench.check(ratio)), "inconclusive");
  bench.answers[1].times = {{"trace", samples(more)}};
  EXPECT_EQ(outcomeName(bench.check(ratio)), "error");
}

TEST(PassCpuLead, IsOverTheCostliestOtherPass) {
  Bench bench;
  const auto rounds_of = [](double ns) { return samples(std::vector<double>(15, ns)); };
  bench.add("hiz", shiftedRecord({8, 8})).times = {
      {"trace", rounds_of(80.0)}, {"light", rounds_of(20.0)}, {"gbuffer", rounds_of(40.0)}};
  const std::string lead = "metric = \"pass_cpu_lead\"\npasses = [\"trace\"]\nstages = [\"hiz\"]\n";
  const CheckResult check = bench.check(expectation(lead + "min = 2\nmax = 2"));
  EXPECT_EQ(check.value, 2.0);
  EXPECT_EQ(outcomeName(check), "pass");
  EXPECT_EQ(check.interval, (std::pair{2.0, 2.0}));
  EXPECT_NE(check.remark.find("over 'gbuffer'"), std::string::npos) << check.remark;
  EXPECT_EQ(outcomeName(bench.check(expectation(lead + "min = 3"))), "fail");
}

TEST(PassCpuLead, NeedsAnotherPass) {
  Bench bench;
  bench.add("hiz", shiftedRecord({8, 8})).times = {{"trace", samples(std::vector<double>(15, 1.0))}};
  EXPECT_EQ(outcomeName(bench.check(expectation(
                "metric = \"pass_cpu_lead\"\npasses = [\"trace\"]\nstages = [\"hiz\"]\nmin = 1"))),
            "error");
}

TEST(PassCpuShare, MayTakeAllPasses) {
  Bench bench;
  const auto rounds_of = [](double ns) { return samples(std::vector<double>(15, ns)); };
  bench.add("hiz", shiftedRecord({8, 8})).times = {{"trace", rounds_of(80.0)}, {"light", rounds_of(20.0)}};
  const CheckResult check = bench.check(expectation(
      "metric = \"pass_cpu_share\"\npasses = [\"trace\"]\nover = [\"all\"]\nstages = [\"hiz\"]\nmax = 0.8"));
  EXPECT_EQ(check.value, 0.8);
}

TEST(CpuRatio, MayBeHeldAgainstAnotherDevice) {
  Bench bench;
  bench.add("hiz", shiftedRecord({8, 8}), "gl-osmesa").times = {
      {"trace", samples(std::vector<double>(15, 11.0))}};
  bench.add("hiz", shiftedRecord({8, 8}), "vk-lavapipe").times = {
      {"trace", samples(std::vector<double>(15, 10.0))}};
  const std::string cross = "metric = \"cpu_ratio\"\ntruth = \"cross:vk-lavapipe\"\n";
  EXPECT_EQ(outcomeName(bench.check(expectation(cross + "max = 1.1"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation(cross + "max = 1.04"))), "fail");
}

TEST(WallRatio, LooksAtTheOtherClock) {
  Bench bench;
  std::vector<TimeSample> one_thread(15, {.cpu_ns = 10.0, .wall_ns = 10.0});
  std::vector<TimeSample> two_threads(15, {.cpu_ns = 10.0, .wall_ns = 5.0});
  bench.add("hiz", shiftedRecord({8, 8}), "vk-lavapipe@1").times = {{"trace", one_thread}};
  bench.add("hiz", shiftedRecord({8, 8}), "vk-lavapipe@2").times = {{"trace", two_threads}};
  const CheckResult check =
      bench.check(expectation("metric = \"wall_ratio\"\ntruth = \"cross:vk-lavapipe@2\"\nmin = 1.85"));
  EXPECT_EQ(check.value, 2.0);
  EXPECT_EQ(outcomeName(check), "pass");
}

TEST(PixelCpuRatio, DividesByThePixels) {
  Bench bench;
  bench.add("hiz", shiftedRecord({16, 16})).times = {{"trace", samples(std::vector<double>(15, 48.0))}};
  bench.add("hiz", shiftedRecord({8, 8})).times = {{"trace", samples(std::vector<double>(15, 10.0))}};
  // Four times the pixels at 4.8 times the cost.
  const CheckResult check =
      bench.check(expectation("metric = \"pixel_cpu_ratio\"\ntruth = \"size:8x8\"\nmax = 1.25"));
  EXPECT_EQ(check.value, 1.2);
  EXPECT_EQ(outcomeName(check), "pass");
}

TEST(RooflineMultiple, IsOverTheLookupsAsFetchesAndThePixelsAsWrites) {
  Bench bench;
  // 64 rays of 10 lookups; a pass of 32 fetches at each of the 64 pixels took 2048 ns: a nanosecond each. So
  // the limit is 640 ns of fetches and 60 of writes.
  bench.add("hiz", shiftedRecord({8, 8})).times = {
      {"trace", samples(std::vector<double>(15, 2100.0))},
      {"bench_dependent_fetch", samples(std::vector<double>(15, 2048.0))},
      {"bench_write", samples(std::vector<double>(15, 60.0))}};
  const std::string multiple = "metric = \"roofline_multiple\"\nstages = [\"hiz\"]\n";
  const CheckResult check = bench.check(expectation(multiple + "max = 3"));
  EXPECT_EQ(check.value, 3.0);
  EXPECT_EQ(outcomeName(check), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation(multiple + "max = 2.5"))), "fail");
  bench.answers[0].times.erase("bench_write");
  EXPECT_EQ(outcomeName(bench.check(expectation(multiple + "max = 3"))), "error");
}

}  // namespace
}  // namespace ssrkit
