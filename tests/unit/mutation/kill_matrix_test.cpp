#include "mutation/kill_matrix.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

using Names = std::vector<std::string>;

MutantRun mutant(const std::string& name, const std::map<std::string, bool>& noticed,
                 const std::string& killed_by = "a.one") {
  return {.mutant = {.name = name, .killed_by = killed_by}, .noticed = noticed};
}

MutantRun wheat(const std::string& name, const std::map<std::string, bool>& noticed) {
  return {.mutant = {.name = name, .is_wheat = true, .edit = {.file = "shaders/a.frag"}}, .noticed = noticed};
}

TEST(KillMatrix, AMutantMustBeNoticedAndAWheatMustNot) {
  EXPECT_FALSE(isFailure(mutant("m", {{"a.one", true}, {"a.two", false}})));
  EXPECT_TRUE(isFailure(mutant("m", {{"a.one", false}})));
  EXPECT_TRUE(isFailure(mutant("m", {})));
  EXPECT_FALSE(isFailure(wheat("w", {{"a.one", false}})));
  EXPECT_TRUE(isFailure(wheat("w", {{"a.one", false}, {"a.two", true}})));
}

TEST(KillMatrix, AWheatThatNoCheckLooksAtHasPassedNothing) {
  EXPECT_TRUE(isFailure(wheat("w", {})));
}

TEST(KillMatrix, WhatCouldNotBeRunHasFailed) {
  MutantRun run = mutant("m", {{"a.one", true}});
  run.problem = "it does not compile";
  EXPECT_TRUE(isFailure(run));
}

TEST(KillMatrix, TheScoreCountsBothKinds) {
  const KillSummary summary = summarise({mutant("m", {{"a.one", true}}), mutant("n", {{"a.one", false}}),
                                         wheat("v", {{"a.one", false}}), wheat("w", {{"a.one", true}})},
                                        {"a.one"});
  EXPECT_EQ(summary.mutants, 2U);
  EXPECT_EQ(summary.killed, 1U);
  EXPECT_EQ(summary.wheats, 2U);
  EXPECT_EQ(summary.rejected, 1U);
  EXPECT_EQ(summary.survivors, Names{"n"});
  EXPECT_EQ(summary.kills.at("a.one"), Names{"m"});  // a wheat is nobody's kill
}

TEST(KillMatrix, AKillerThatWasNotForetoldIsNamed) {
  const KillSummary summary = summarise(
      {mutant("m", {{"a.one", false}, {"a.two", true}}), mutant("n", {{"a.one", true}, {"a.two", true}})},
      {"a.one", "a.two"});
  EXPECT_EQ(summary.unexpected_killers, Names{"m"});
}

TEST(KillMatrix, ChecksThatNoticeTheVerySameAreCopies) {
  const KillSummary summary = summarise({mutant("m", {{"a", true}, {"b", true}, {"c", true}}),
                                         mutant("n", {{"a", true}, {"b", true}, {"c", false}})},
                                        {"a", "b", "c", "d"});
  EXPECT_EQ(summary.copies, (std::vector<Names>{{"a", "b"}}));
}

TEST(KillMatrix, ChecksThatNoticeNothingAreIdleAndNoCopies) {
  const KillSummary summary =
      summarise({mutant("m", {{"a", true}, {"b", false}, {"c", false}})}, {"a", "b", "c"});
  EXPECT_EQ(summary.idle, (Names{"b", "c"}));
  EXPECT_TRUE(summary.copies.empty());
}

TEST(KillMatrix, TheOnlyOneToNoticeIsNeeded) {
  const KillSummary summary = summarise(
      {mutant("m", {{"a", true}, {"b", true}}), mutant("n", {{"b", true}}), mutant("o", {{"b", true}})},
      {"a", "b"});
  EXPECT_EQ(summary.needed, Names{"b"});
}

}  // namespace
}  // namespace ssrkit
