#include <gtest/gtest.h>

#include "check/judge_claim.h"
#include "check/read_claims.h"
#include "complaints.h"

namespace ssrkit {
namespace {

constexpr const char* kGoodClaim = R"([claim]
source = "somebody, 2020"
says = "rays are cheap"
finding = "refuted"
if_confirmed = "They are."
if_refuted = "They are not."

[test]
id = "cheap_rays"
about = "a ray makes at most 10 lookups"
scenes = ["m1"]
stages = ["hiz", "walk"]

[[expect]]
name = "cost"
metric = "mean_lookups"
stages = ["hiz"]
max = 10
refuted_above = 20

[[expect]]
name = "ratio"
metric = "lookup_ratio"
stages = ["hiz"]
truth = "stage:walk"
min = 2
max = 4
refuted_below = 1
refuted_above = 8

[[expect]]
name = "shown"
metric = "p95_lookups"
)";

std::string changedClaim(std::string_view from, std::string_view to) {
  return withChange(kGoodClaim, from, to);
}

std::string claimComplaint(const std::string& content) {
  const Expected<Claim> claim = readClaim(content, "c.toml");
  return claim ? "read" : sentence(claim.error());
}

TEST(ReadClaim, GivesWhatTheFileSays) {
  const Expected<Claim> claim = readClaim(kGoodClaim, "c.toml");
  ASSERT_TRUE(claim.has_value()) << sentence(claim.error());
  EXPECT_EQ(claim->name, "cheap_rays");
  EXPECT_EQ(claim->source, "somebody, 2020");
  EXPECT_EQ(claim->says, "rays are cheap");
  EXPECT_EQ(claim->finding, ClaimVerdict::kRefuted);
  EXPECT_EQ(claim->if_confirmed, "They are.");
  EXPECT_EQ(claim->if_refuted, "They are not.");
  EXPECT_EQ(claim->test.about, "a ray makes at most 10 lookups");
  ASSERT_EQ(claim->refuting.size(), 3U);
  EXPECT_EQ(claim->refuting[0].above, 20.0);
  EXPECT_FALSE(claim->refuting[0].below.has_value());
  EXPECT_EQ(claim->refuting[1].below, 1.0);
  EXPECT_TRUE(claim->decides(0));
  EXPECT_FALSE(claim->decides(2));
  EXPECT_FALSE(claim->test.expectations[2].max.has_value());
}

TEST(ReadClaim, SaysWhatIsWrongAndWhere) {
  EXPECT_TRUE(says(claimComplaint(changedClaim("says =", "sayz =")),
                   {"c.toml:3:1", "unknown key 'sayz' in [claim]", "did you mean 'says'?"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("finding = \"refuted\"", "finding = \"refutted\"")),
                   {"c.toml:4:", "refutted", "did you mean 'refuted'?"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("source = \"somebody, 2020\"\n", "")),
                   {"[claim] lacks the key 'source'"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("[claim]", "[clam]")),
                   {"unknown key 'clam'", "did you mean 'claim'?"}));
  EXPECT_TRUE(says(claimComplaint(std::string(kGoodClaim).substr(std::string(kGoodClaim).find("[test]"))),
                   {"the file has no [claim] section"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("refuted_above = 20", "refuted_abov = 20")),
                   {"c.toml:19:1", "did you mean 'refuted_above'?"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("refuted_above = 20", "refuted_above = 10")),
                   {"c.toml:19:17", "does not lie beyond 'max': a value could confirm and refute"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("refuted_below = 1", "refuted_below = 3")),
                   {"does not lie beyond 'min'"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("refuted_above = 20", "refuted_below = 20")),
                   {"'refuted_below' needs 'min'"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("refuted_above = 20\n", "")),
                   {"nothing refutes 'cost'", "add refuted_above"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("max = 10\nrefuted_above = 20\n", "refuted_above = 20\n")),
                   {"'refuted_above' needs 'max'"}));
  EXPECT_TRUE(says(claimComplaint(changedClaim("max = 10", "max = \"ten\"")), {"c.toml:18:7", "must be"}));
  EXPECT_TRUE(says(claimComplaint("[claim"), {"c.toml:1:"}));
}

TEST(ReadClaim, WantsSomethingThatDecides) {
  const std::string shown_only =
      std::string(kGoodClaim).substr(0, std::string(kGoodClaim).find("[[expect]]")) +
      "[[expect]]\nmetric = \"p95_lookups\"\n";
  EXPECT_TRUE(says(claimComplaint(shown_only), {"nothing decides the claim", "add max or min"}));
}

TEST(ReadExpectations, TakesNoClaims) {
  const auto test = readExpectations(kGoodClaim, "c.toml");
  ASSERT_FALSE(test.has_value());
  EXPECT_NE(sentence(test.error()).find("unknown key 'claim'"), std::string::npos);
}

CheckResult made(const std::string& name, double value, Outcome outcome) {
  CheckResult check;
  check.id = "cheap_rays." + name;
  check.value = value;
  check.outcome = outcome;
  check.compared = 100;
  return check;
}

// The verdict on the good claim by the values of `cost` and `ratio`.
ClaimVerdict verdict(std::vector<CheckResult> checks) {
  const Expected<Claim> claim = readClaim(kGoodClaim, "c.toml");
  return judgeClaim(*claim, checks).verdict;
}

TEST(JudgeClaim, AllMustConfirmAndOneRefutes) {
  using enum Outcome;
  EXPECT_EQ(verdict({made("cost", 9, kPass), made("ratio", 3, kPass)}), ClaimVerdict::kConfirmed);
  EXPECT_EQ(verdict({made("cost", 9, kPass), made("ratio", 9, kFail)}), ClaimVerdict::kRefuted);
  EXPECT_EQ(verdict({made("cost", 9, kPass), made("ratio", 0.5, kFail)}), ClaimVerdict::kRefuted);
  EXPECT_EQ(verdict({made("cost", 9, kPass), made("ratio", 6, kFail)}), ClaimVerdict::kInconclusive);
  EXPECT_EQ(verdict({made("cost", 20, kFail), made("ratio", 6, kFail)}), ClaimVerdict::kRefuted);
}

TEST(JudgeClaim, ANoisyRatioDecidesByItsWholeInterval) {
  using enum Outcome;
  CheckResult noisy = made("ratio", 9, kInconclusive);
  noisy.interval = {7.0, 11.0};
  EXPECT_EQ(verdict({made("cost", 9, kPass), noisy}), ClaimVerdict::kInconclusive);
  noisy.interval = {8.0, 11.0};
  EXPECT_EQ(verdict({made("cost", 9, kPass), noisy}), ClaimVerdict::kRefuted);
  noisy.interval = {0.5, 1.1};
  EXPECT_EQ(verdict({made("cost", 9, kPass), noisy}), ClaimVerdict::kInconclusive);
  noisy.interval = {0.5, 1.0};
  EXPECT_EQ(verdict({made("cost", 9, kPass), noisy}), ClaimVerdict::kRefuted);
}

TEST(JudgeClaim, FewRoundsOrRaysSettleNothing) {
  CheckResult few = made("ratio", 0.5, Outcome::kInconclusive);
  few.value.reset();
  EXPECT_EQ(verdict({made("cost", 9, Outcome::kPass), few}), ClaimVerdict::kInconclusive);
}

TEST(JudgeClaim, WhatIsOnlyShownDoesNotDecide) {
  const Expected<Claim> claim = readClaim(kGoodClaim, "c.toml");
  const std::vector<CheckResult> checks = {made("cost", 9, Outcome::kPass), made("ratio", 3, Outcome::kPass),
                                           made("shown", 1e9, Outcome::kPass)};
  const ClaimResult result = judgeClaim(*claim, checks);
  EXPECT_EQ(result.verdict, ClaimVerdict::kConfirmed);
  EXPECT_FALSE(result.figures[2].decides);
}

TEST(JudgeClaim, AFigureOfNothingThatMayBeEmptyDoesNotDecide) {
  CheckResult empty = made("cost", 0, Outcome::kPass);
  empty.compared = 0;
  EXPECT_EQ(verdict({empty, made("ratio", 9, Outcome::kFail)}), ClaimVerdict::kRefuted);
  EXPECT_EQ(verdict({empty}), ClaimVerdict::kNotMeasured);
}

TEST(JudgeClaim, NothingIsKnownOfWhatWasNotMeasured) {
  using enum Outcome;
  const ClaimVerdict unknown = ClaimVerdict::kNotMeasured;
  EXPECT_EQ(verdict({}), unknown);
  EXPECT_EQ(verdict({made("cost", 30, kFail), made("ratio", 3, kError)}), unknown);
  EXPECT_EQ(verdict({made("cost", 30, kFail), made("shown", 3, kMissing)}), unknown);
  EXPECT_EQ(verdict({made("cost", 9, kPass), made("runs", 0, kCrash)}), unknown);
  CheckResult empty = made("cost", 0, kFail);
  empty.compared = 0;
  EXPECT_EQ(verdict({empty, made("ratio", 3, kPass)}), unknown);
}

}  // namespace
}  // namespace ssrkit
