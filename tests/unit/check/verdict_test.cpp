#include "check/verdict.h"

#include <gtest/gtest.h>

#include "made_answers.h"
#include "not_finite.h"

namespace ssrkit {
namespace {

// A 1-row image in which one ray is held against one answer of the oracle.
Verdict verdictOf(const RayHit& yours, const RayHit& oracle, Ambiguity ambiguity = Ambiguity::kNone) {
  Bench bench;
  const Size size{8, 8};
  RayRecord record{size, std::vector<RayHit>(64, without(RayClass::kMasked))};
  RayRecord truth = record;
  record.rays[0] = yours;
  truth.rays[0] = oracle;
  Answer& answer = bench.add("hiz", record);
  bench.setOracle(answer, truth).ambiguity[0] = ambiguity;
  const OracleInput& input = bench.setWorld(answer, kInfinity);
  return compareWithOracle(*answer.record, *answer.oracle, input)[0];
}

TEST(Verdict, EveryNameLeadsBackToItsVerdict) {
  for (int i = 0; i < kVerdictCount; ++i) {
    EXPECT_EQ(verdictFromName(name(static_cast<Verdict>(i))), static_cast<Verdict>(i));
  }
  EXPECT_STREQ(name(Verdict::kFalseHit), "FALSE_HIT");
}

TEST(Verdict, PixelsWithoutARayAreNotCompared) {
  EXPECT_EQ(verdictOf(without(RayClass::kMasked), without(RayClass::kMasked)), Verdict::kNone);
  EXPECT_EQ(verdictOf(without(RayClass::kBackground), without(RayClass::kBackground)), Verdict::kNone);
  EXPECT_EQ(verdictOf(without(RayClass::kMasked), without(RayClass::kBackground)), Verdict::kWrong);
}

TEST(Verdict, TheSameTexelAndClassIsTheSame) {
  EXPECT_EQ(verdictOf(hitAt(3, 4, 7), hitAt(3, 4, 900)), Verdict::kSame);
  EXPECT_EQ(verdictOf(without(RayClass::kRange), without(RayClass::kRange)), Verdict::kSame);
}

TEST(Verdict, OneTexelOffOnEitherAxisIsNearAndTwoAreWrong) {
  EXPECT_EQ(verdictOf(hitAt(4, 5), hitAt(3, 4)), Verdict::kNear);
  EXPECT_EQ(verdictOf(hitAt(5, 4), hitAt(3, 4)), Verdict::kWrong);
  EXPECT_EQ(verdictOf(hitAt(3, 6), hitAt(3, 4)), Verdict::kWrong);
}

TEST(Verdict, HitsAgainstMissesAreFalseOrMissed) {
  EXPECT_EQ(verdictOf(hitAt(3, 4), without(RayClass::kOffscreen)), Verdict::kFalseHit);
  EXPECT_EQ(verdictOf(without(RayClass::kOffscreen), hitAt(3, 4)), Verdict::kMissedHit);
  EXPECT_EQ(verdictOf(without(RayClass::kBudget), hitAt(3, 4)), Verdict::kMissedHit);
  EXPECT_EQ(verdictOf(without(RayClass::kRange), without(RayClass::kOffscreen)), Verdict::kWrong);
}

TEST(Verdict, TiesExcuseEveryDifferenceButAreNamed) {
  EXPECT_EQ(verdictOf(hitAt(3, 4), without(RayClass::kOffscreen), Ambiguity::kDepth), Verdict::kAmbiguous);
  EXPECT_EQ(verdictOf(hitAt(4, 4), hitAt(3, 4), Ambiguity::kPosition), Verdict::kAmbiguous);
  EXPECT_EQ(verdictOf(hitAt(3, 4), hitAt(3, 4), Ambiguity::kPosition), Verdict::kSame);
}

TEST(Verdict, CountsAddUpToTheImage) {
  const std::vector<Verdict> verdicts = {Verdict::kSame, Verdict::kLeak, Verdict::kSame};
  const VerdictCounts counts = countVerdicts(verdicts);
  EXPECT_EQ(counts[static_cast<std::size_t>(Verdict::kSame)], 2U);
  EXPECT_EQ(counts[static_cast<std::size_t>(Verdict::kLeak)], 1U);
  EXPECT_EQ(counts[static_cast<std::size_t>(Verdict::kWrong)], 0U);
}

}  // namespace
}  // namespace ssrkit
