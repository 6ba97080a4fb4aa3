#include "check/outcome.h"

#include <gtest/gtest.h>

#include <vector>

#include "check/check_result.h"

namespace ssrkit {
namespace {

TEST(Outcome, EveryNameLeadsBackToItsOutcome) {
  using enum Outcome;
  for (int i = 0; i < kOutcomeCount; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    EXPECT_EQ(outcomeFromName(name(outcome)), outcome);
  }
  EXPECT_STREQ(name(kInconclusive), "inconclusive");
  EXPECT_EQ(outcomeFromName("passed"), std::nullopt);
}

TEST(Outcome, ARunIsWellOnlyWhenSomethingRanAndNothingFailed) {
  using enum Outcome;
  EXPECT_EQ(exitCode(std::vector{kPass, kWarn, kXfail, kSkip}), 0);
  EXPECT_EQ(exitCode(std::vector<Outcome>{}), 1);
  EXPECT_EQ(exitCode(std::vector{kSkip, kSkip}), 1);
}

TEST(Outcome, EveryKindOfFailureGivesOneAndBeatsDoubt) {
  using enum Outcome;
  for (const Outcome failure : {kFail, kError, kCrash, kTimeout, kLimiter, kMissing, kXpass}) {
    EXPECT_EQ(exitCode(std::vector{kPass, failure, kInconclusive}), 1) << name(failure);
  }
}

TEST(Outcome, OnlyDoubtGivesFour) {
  using enum Outcome;
  EXPECT_EQ(exitCode(std::vector{kPass, kFlake}), 4);
  EXPECT_EQ(exitCode(std::vector{kPass, kInconclusive}), 4);
}

TEST(Outcome, TheClosingLineCountsWhatRan) {
  using enum Outcome;
  EXPECT_EQ(closingLine(std::vector{kPass, kXfail, kWarn, kFail, kCrash}), "3 passed, 2 failed");
  EXPECT_EQ(closingLine(std::vector{kPass, kSkip}), "1 passed, 0 failed, 1 skipped");
  EXPECT_EQ(closingLine(std::vector{kFlake, kInconclusive}), "0 passed, 0 failed");
}

TEST(CheckResult, BoundsAreShownWithTheirUnit) {
  CheckResult result;
  result.unit = "rays";
  EXPECT_EQ(boundText(result), "");
  result.max = 0.0;
  EXPECT_EQ(boundText(result), "<= 0 rays");
  result.min = -1.5;
  EXPECT_EQ(boundText(result), "-1.5 .. 0 rays");
  result.max.reset();
  EXPECT_EQ(boundText(result), ">= -1.5 rays");
}

}  // namespace
}  // namespace ssrkit
