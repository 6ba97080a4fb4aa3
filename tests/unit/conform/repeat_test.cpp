#include <gtest/gtest.h>

#include "conform/isolate.h"
#include "made_records.h"

namespace ssrkit {
namespace {

std::vector<CheckResult> runWith(Outcome outcome) {
  return {madeCheck("t.rays", outcome)};
}

TEST(Repeats, AlwaysTheSameStaysWhatItIs) {
  using enum Outcome;
  for (const Outcome outcome : {kPass, kFail, kInconclusive}) {
    const std::vector runs = {runWith(outcome), runWith(outcome), runWith(outcome)};
    EXPECT_EQ(outcome, combineRepeats(runs).at(0).outcome);
  }
}

TEST(Repeats, OneFailureAmongPassesIsAFlakeWithItsCount) {
  const std::vector runs = {runWith(Outcome::kPass), runWith(Outcome::kFail), runWith(Outcome::kPass)};
  const auto combined = combineRepeats(runs);
  EXPECT_EQ(Outcome::kFlake, combined.at(0).outcome);
  EXPECT_NE(std::string::npos, combined.at(0).message.find("failed in 1 of 3 runs"));
  EXPECT_EQ(3.0, combined.at(0).value) << "the run that failed has something to tell";
}

TEST(Repeats, AValueThatWandersIsAFlakeAlthoughItPasses) {
  std::vector runs = {runWith(Outcome::kPass), runWith(Outcome::kPass)};
  runs[1][0].value = 0.25;
  EXPECT_EQ(Outcome::kFlake, combineRepeats(runs).at(0).outcome);
}

TEST(Repeats, ACrashInOneRunIsAFlakeBesideTheChecks) {
  CheckResult crash = madeCheck("t.runs", Outcome::kCrash);
  crash.stage = "";
  const std::vector<std::vector<CheckResult>> runs = {runWith(Outcome::kPass), {crash}};
  const auto combined = combineRepeats(runs);
  ASSERT_EQ(2U, combined.size());
  EXPECT_EQ(Outcome::kFlake, combined[1].outcome);
}

}  // namespace
}  // namespace ssrkit
