#include "check/judge.h"

#include <gtest/gtest.h>

#include "made_answers.h"

namespace ssrkit {
namespace {

TestFile fileOf(const std::string& expects, const std::string& more = "") {
  const Expected<TestFile> test = readExpectations(
      "[test]\nid = \"t\"\nabout = \"a\"\nscenes = [\"all\"]\nstages = [\"hiz\", \"walk\"]\n" + more +
          expects,
      "t.toml");
  EXPECT_TRUE(test.has_value()) << sentence(test.error());
  return test.value_or(TestFile{});
}

std::string noCommand(const Answer& /*answer*/) {
  return "";
}

TEST(Judge, AsksEachAnswerOnceAndNeverTheTruthItself) {
  Bench bench;
  for (const char* device : {"gl-osmesa", "vk-lavapipe"}) {
    for (const char* stage : {"hiz", "walk"}) {
      bench.add(stage, shiftedRecord({4, 4}), device);
    }
  }
  const TestFile test = fileOf(
      "[[expect]]\nmetric = \"identical\"\ntruth = \"cross:gl-osmesa\"\n"
      "[[expect]]\nmetric = \"identical\"\nname = \"stages\"\ntruth = \"stage:walk\"\n"
      "[[expect]]\nmetric = \"finite\"\n");
  const std::vector<CheckResult> results = judge(test, "made", bench.answers, noCommand);
  ASSERT_EQ(results.size(), 2U + 2U + 4U);
  for (const CheckResult& result : results) {
    EXPECT_EQ(result.outcome, Outcome::kPass) << result.message;
  }
  EXPECT_EQ(results[0].device, "vk-lavapipe");
  EXPECT_EQ(results[2].stage, "hiz");
}

TEST(Judge, AnExpectationThatNoAnswerFitsIsMissing) {
  Bench bench;
  bench.add("walk", shiftedRecord({4, 4}));
  const auto results = judge(fileOf("[[expect]]\nmetric = \"finite\"\nstages = [\"hiz\"]\n"), "made",
                             bench.answers, noCommand);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].outcome, Outcome::kMissing);
}

TEST(Judge, FrameBuffersAreAskedOncePerDeviceAndInputsAreKeptApart) {
  Bench bench;
  Answer& frame = bench.add("", shiftedRecord({4, 4}));
  bench.setImage(frame, "lit", 1.0F);
  bench.add("hiz", shiftedRecord({4, 4}));
  bench.add("hiz", shiftedRecord({4, 4})).input = "gl-osmesa";
  const auto frame_results =
      judge(fileOf("[[expect]]\nmetric = \"finite\"\nbuffer = \"lit\"\n"), "made", bench.answers, noCommand);
  ASSERT_EQ(frame_results.size(), 1U);
  EXPECT_EQ(frame_results[0].outcome, Outcome::kPass);
  const auto round_trip =
      judge(fileOf("[[expect]]\nmetric = \"identical\"\ntruth = \"rendered\"\n", "input = \"gl-osmesa\"\n"),
            "made", bench.answers, noCommand);
  ASSERT_EQ(round_trip.size(), 1U);
  EXPECT_EQ(round_trip[0].outcome, Outcome::kPass);
}

TEST(Judge, MetricsOverCasesAreAskedOnce) {
  Bench bench;
  for (const int budget : {4, 8}) {
    bench.add("hiz", shiftedRecord({4, 4}), "gl-osmesa", budget == 4 ? "a" : "b").parameters.lookup_budget =
        budget;
  }
  const TestFile test =
      fileOf("[[expect]]\nmetric = \"budget_monotone\"\ncases = [\"a\", \"b\"]\nstages = [\"hiz\"]\n",
             "[[case]]\nname = \"a\"\nlookup_budget = 4\n[[case]]\nname = \"b\"\nlookup_budget = 8\n");
  const auto results = judge(test, "made", bench.answers, noCommand);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].outcome, Outcome::kPass) << results[0].message;
}

TEST(Judge, AVariantsFrameIsHeldAgainstThePlainOne) {
  Bench bench;
  const auto add_frame = [&](const std::string& variant, std::vector<std::string> cases, float lit) {
    Answer& frame = bench.add("", shiftedRecord({4, 4}));
    frame.variant = variant;
    frame.case_name = variant.empty() ? "" : cases.front();
    frame.frame_cases = std::move(cases);
    bench.setImage(frame, "lit", lit);
  };
  add_frame("", {"plain", "thin"}, 1.0F);
  add_frame("tiled", {"in_tiles"}, 1.0F);
  add_frame("robust", {"clamped"}, 2.0F);
  const std::string cases =
      "[[case]]\nname = \"plain\"\n[[case]]\nname = \"thin\"\nthickness_m = 0.1\n"
      "[[case]]\nname = \"in_tiles\"\nvariant = \"tiled\"\n"
      "[[case]]\nname = \"clamped\"\nvariant = \"robust\"\n";
  const auto results =
      judge(fileOf(cases + "[[expect]]\nmetric = \"identical\"\nbuffer = \"lit\"\ntruth = \"case:plain\"\n"),
            "made", bench.answers, noCommand);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].case_name, "in_tiles");
  EXPECT_EQ(results[0].outcome, Outcome::kPass) << results[0].message;
  EXPECT_EQ(results[1].case_name, "clamped");
  EXPECT_EQ(results[1].outcome, Outcome::kFail);
  const auto of_some = judge(fileOf(cases + "[[expect]]\nmetric = \"identical\"\nbuffer = \"lit\"\n"
                                            "cases = [\"in_tiles\"]\ntruth = \"case:plain\"\n"),
                             "made", bench.answers, noCommand);
  ASSERT_EQ(of_some.size(), 1U);
  EXPECT_EQ(of_some[0].case_name, "in_tiles");
}

}  // namespace
}  // namespace ssrkit
