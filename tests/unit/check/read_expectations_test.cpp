#include "check/read_expectations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "complaints.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {
namespace {

constexpr const char* kGoodTest = R"([test]
id = "t.one"
about = "a test"
scenes = ["m1"]
sizes = ["640x360", "1x1"]
stages = ["hiz", "walk"]
rounds = 12

[[case]]
name = "t_inf"
thickness_m = inf

[[case]]
name = "t_5pct"
thickness_m = 0
thickness_rel = 0.05
form = "textbook"

[[expect]]
metric = "different_rays"

[[expect]]
name = "cost"
metric = "lookup_ratio"
stages = ["hiz"]
cases = ["t_inf"]
sizes = ["640x360"]
truth = "stage:walk"
min = 13
)";

std::string changedTest(std::string_view from, std::string_view to) {
  return withChange(kGoodTest, from, to);
}

// The complaint about a file, or "read" when there is none.
std::string testComplaint(const std::string& content, const KnownNames& known = {}) {
  const Expected<TestFile> test = readExpectations(content, "t.toml", known);
  return test ? "read" : sentence(test.error());
}

TEST(ReadExpectations, AGoodFileIsReadWhole) {
  const Expected<TestFile> test = readExpectations(kGoodTest, "t.toml");
  ASSERT_TRUE(test.has_value()) << sentence(test.error());
  EXPECT_EQ(test->id, "t.one");
  EXPECT_EQ(test->sizes, (std::vector<Size>{{640, 360}, {1, 1}}));
  EXPECT_EQ(test->rounds, 12);
  ASSERT_EQ(test->cases.size(), 2U);
  TraceParameters parameters;
  for (const auto& [name, value] : test->cases[1].parameters) {
    ASSERT_TRUE(setParameter(parameters, name, value, "").has_value()) << name;
  }
  EXPECT_EQ(parameters.thickness_m, 0.0);
  EXPECT_EQ(parameters.thickness_rel, 0.05);
  EXPECT_EQ(parameters.form, TracerForm::kTextbook);
  ASSERT_EQ(test->expectations.size(), 2U);
  const Expectation& first = test->expectations[0];
  EXPECT_EQ(first.name, "different_rays");
  EXPECT_EQ(first.truth.kind, TruthKind::kOracle);
  EXPECT_EQ(first.max, 0.0);
  EXPECT_EQ(first.stages, (std::vector<std::string>{"hiz", "walk"}));
  EXPECT_EQ(first.cases, (std::vector<std::string>{"t_inf", "t_5pct"}));
  const Expectation& second = test->expectations[1];
  EXPECT_EQ(second.truth, (Truth{TruthKind::kStage, "walk"}));
  EXPECT_EQ(second.min, 13.0);
  EXPECT_EQ(second.max, std::nullopt);
  EXPECT_EQ(second.where, "t.toml:22:1");
}

TEST(ReadExpectations, ACasesThicknessIsRelativeAloneWhereItGivesNoneInMetres) {
  const Expected<TestFile> test = readExpectations(changedTest("thickness_m = 0\n", ""), "t.toml");
  ASSERT_TRUE(test.has_value()) << sentence(test.error());
  TraceParameters parameters{.thickness_m = 0.3};  // the scene's
  for (const auto& [name, value] : test->cases[1].parameters) {
    ASSERT_TRUE(setParameter(parameters, name, value, "").has_value()) << name;
  }
  EXPECT_EQ(parameters.thickness_m, 0.0);
  EXPECT_EQ(parameters.thickness_rel, 0.05);
}

TEST(ReadExpectations, WhatIsNoTomlIsRefusedWithItsPlace) {
  EXPECT_TRUE(
      says(testComplaint("[test]\nid = \n"), {"t.toml:2:", "could not read the expectations 't.toml'"}));
  EXPECT_TRUE(says(testComplaint("[test]\nid = \"a\"\nid = \"b\"\n"), {"t.toml:3:"}));
  EXPECT_TRUE(says(testComplaint(""), {"no [test] section"}));
}

TEST(ReadExpectations, UnknownKeysNameTheNearest) {
  EXPECT_TRUE(says(testComplaint(changedTest("about =", "abuot =")),
                   {"t.toml:3:1", "unknown key 'abuot' in [test]", "'about'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("thickness_rel", "thickness_rell")),
                   {"t.toml:16:1", "in [[case]]", "'thickness_rel'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "mim = 13")), {"t.toml:29:1", "in [[expect]]"}));
  EXPECT_TRUE(says(testComplaint(changedTest("[[case]]", "[[cases]]")), {"unknown key 'cases'", "'case'"}));
}

TEST(ReadExpectations, KeysOfOtherMetricsAreUnknown) {
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "min = 13\nverdicts = [\"LEAK\"]")),
                   {"unknown key 'verdicts'"}));
  EXPECT_TRUE(
      says(testComplaint(changedTest("min = 13", "min = 13\nmargin = 0.1")), {"unknown key 'margin'"}));
}

TEST(ReadExpectations, WrongTypesSayWhatWasWanted) {
  EXPECT_TRUE(says(testComplaint(changedTest("\"t.one\"", "7")),
                   {"t.toml:2:6", "'id' in [test] must be text, not an integer"}));
  EXPECT_TRUE(
      says(testComplaint(changedTest("[\"m1\"]", "\"m1\"")), {"t.toml:4:", "must be a list, not text"}));
  EXPECT_TRUE(says(testComplaint(changedTest("[\"m1\"]", "[\"m1\", 3]")),
                   {"t.toml:4:", "list of text, not of an integer"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "min = \"13\"")), {"must be a number, not text"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "rounds = 1.5")), {"must be an integer"}));
  EXPECT_TRUE(
      says(testComplaint(changedTest("thickness_m = inf", "thickness_m = [1]")), {"cannot be a list"}));
  EXPECT_TRUE(
      says(testComplaint("[test]\nid = \"a\"\nabout = \"b\"\nscenes = [\"all\"]\n[case]\nname = \"c\"\n"),
           {"t.toml:5:", "write it as [[case]]"}));
  EXPECT_TRUE(says(testComplaint("test = 1\n"), {"no [test] section"}));
  EXPECT_TRUE(says(testComplaint(changedTest("[[expect]]\nmetric", "expect = [1]\nmetric")), {"t.toml:"}));
}

TEST(ReadExpectations, MissingKeysAreNamed) {
  EXPECT_TRUE(says(testComplaint(changedTest("id = \"t.one\"", "")), {"[test] lacks the key 'id'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("about = \"a test\"", "")), {"lacks the key 'about'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("scenes = [\"m1\"]", "")), {"lacks the key 'scenes'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("name = \"t_inf\"", "")),
                   {"t.toml:9:1", "[[case]] lacks the key 'name'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("metric = \"different_rays\"", "")),
                   {"t.toml:19:1", "lacks the key 'metric'"}));
  EXPECT_TRUE(
      says(testComplaint("[test]\nid = \"a\"\nabout = \"b\"\nscenes = [\"all\"]\n"), {"expects nothing"}));
}

TEST(ReadExpectations, NamesGivenTwiceAreRefused) {
  EXPECT_TRUE(says(testComplaint(changedTest("\"t_5pct\"", "\"t_inf\"")),
                   {"t.toml:14:8", "two cases are named 't_inf'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("\"cost\"", "\"different_rays\"")),
                   {"two expectations are named 'different_rays'"}));
  EXPECT_TRUE(
      says(testComplaint(changedTest("[\"hiz\", \"walk\"]", "[\"hiz\", \"hiz\"]")), {"names 'hiz' twice"}));
}

TEST(ReadExpectations, IdsAreSmallLettersDigitsDotsAndDashes) {
  EXPECT_TRUE(says(testComplaint(changedTest("t.one", "T one")), {"t.toml:2:6", "'T one' is no id"}));
  EXPECT_TRUE(says(testComplaint(changedTest("t_inf", "t inf")), {"'t inf' is no id"}));
}

TEST(ReadExpectations, ASequenceIsReadWhereItIsGiven) {
  const Expected<TestFile> plain = readExpectations(kGoodTest, "t.toml");
  ASSERT_TRUE(plain.has_value());
  EXPECT_FALSE(plain->frames.has_value() || plain->time_s.has_value() || plain->time_step_s.has_value());
  const Expected<TestFile> test =
      readExpectations(changedTest("rounds = 12", "frames = 3\ntime_s = -1.5\ntime_step_s = 0"), "t.toml");
  ASSERT_TRUE(test.has_value()) << sentence(test.error());
  EXPECT_EQ(test->frames, 3);
  EXPECT_EQ(test->time_s, -1.5);
  EXPECT_EQ(test->time_step_s, 0.0);
}

TEST(ReadExpectations, ValuesOutOfRangeAreRefused) {
  EXPECT_TRUE(says(testComplaint(changedTest("640x360", "640*360")), {"t.toml:5:", "is no size"}));
  EXPECT_TRUE(says(testComplaint(changedTest("640x360", "0x360")), {"is no size"}));
  EXPECT_TRUE(says(testComplaint(changedTest("640x360", "16385x1")), {"is no size"}));
  EXPECT_TRUE(says(testComplaint(changedTest("640x360", "1.5x2")), {"is no size"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "rounds = 0")), {"outside 1 to 1000"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "frames = 0")), {"outside 1 to 1000"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "time_step_s = -0.1")), {"'time_step_s'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "time_s = inf")), {"'time_s'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "time = 1.0")), {"'time'"}));
  EXPECT_TRUE(
      says(testComplaint(changedTest("thickness_rel = 0.05", "thickness_rel = -1.0")), {"t.toml:16:"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "min = nan")), {"'min'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "min = 13\nmax = 12")), {"larger than 'max'"}));
}

TEST(ReadExpectations, MetricsAndTheirTruthsMustFit) {
  EXPECT_TRUE(says(testComplaint(changedTest("different_rays", "diferent_rays")),
                   {"unknown metric", "'different_rays'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("stage:walk", "stage:")), {"cannot be held against 'stage:'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("stage:walk", "oracle")),
                   {"'lookup_ratio' cannot be held against 'oracle'", "stage:NAME"}));
  EXPECT_TRUE(says(testComplaint(changedTest("truth = \"stage:walk\"\n", "")), {"needs a truth"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "")), {"no bound to hold"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "min = 13\nunit = \"px\"")),
                   {"in 'times fewer lookups', not in 'px'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("min = 13", "min = 13\nbuffer = \"dist_view\"")),
                   {"cannot judge the buffer 'dist_view'"}));
}

TEST(ReadExpectations, ScopesArePartsOfTheTest) {
  EXPECT_TRUE(
      says(testComplaint(changedTest("stages = [\"hiz\"]", "stages = [\"dda\"]")), {"unknown stage 'dda'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("cases = [\"t_inf\"]", "cases = [\"t_in\"]")),
                   {"unknown case 't_in'", "'t_inf'"}));
  EXPECT_TRUE(says(testComplaint(changedTest("sizes = [\"640x360\"]\ntruth", "sizes = [\"2x2\"]\ntruth")),
                   {"not among the test's sizes"}));
  EXPECT_TRUE(says(testComplaint(changedTest("stages = [\"hiz\", \"walk\"]\n", "")), {"the test runs none"}));
}

TEST(ReadExpectations, MetricsOverCasesNeedTwoAndTimedOnesNeedRounds) {
  EXPECT_TRUE(
      says(testComplaint(changedTest("\"different_rays\"", "\"budget_monotone\"")), {"at least two cases"}));
  EXPECT_TRUE(says(testComplaint(changedTest("rounds = 12", "") +
                                 "[[expect]]\nmetric = \"cpu_ratio\"\ntruth = \"stage:walk\"\nmax = 1.0\n"),
                   {"needs timings"}));
}

TEST(ReadExpectations, NamesOutsideTheKitAreRefusedWhereTheyAreKnown) {
  const KnownNames known{{"m1", "clutter"}, {"gl-osmesa"}, {"hiz", "walk"}};
  EXPECT_EQ(testComplaint(kGoodTest, known), "read");
  EXPECT_NE(testComplaint(changedTest("\"m1\"", "\"m9\""), known).find("unknown scene 'm9'"),
            std::string::npos);
  EXPECT_NE(testComplaint(changedTest("rounds", "input = \"gl-osmes\"\nrounds"), known).find("'gl-osmesa'"),
            std::string::npos);
  EXPECT_NE(testComplaint(changedTest("stage:walk", "stage:wolk"), known).find("unknown stage 'wolk'"),
            std::string::npos);
}

TEST(LoadExpectations, FoldersAreReadInOrderAndIdsAreUnique) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "ssrkit_expect";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  EXPECT_FALSE(loadExpectations(folder).has_value());
  std::ofstream(folder / "b.toml") << kGoodTest;
  std::ofstream(folder / "a.toml") << changedTest("t.one", "t.two");
  const auto tests = loadExpectations(folder);
  ASSERT_TRUE(tests.has_value()) << sentence(tests.error());
  ASSERT_EQ(tests->size(), 2U);
  EXPECT_EQ(tests->front().id, "t.two");
  std::ofstream(folder / "c.toml") << kGoodTest;
  const auto doubled = loadExpectations(folder);
  ASSERT_FALSE(doubled.has_value());
  EXPECT_NE(doubled.error().problem.find("'t.one'"), std::string::npos);
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(loadExpectations(folder).has_value());
}

TEST(LoadExpectations, TheBuiltInFilesAreAllGood) {
  const std::filesystem::path folder = std::filesystem::path(SSRKIT_SOURCE_DIR) / "tests" / "expect";
  const KnownNames known{
      {"m1", "m2", "m3", "m4", "clutter", "corridor", "curved", "facing", "gloss", "moving", "outdoor",
       "thin"},
      {"gl-osmesa", "vk-lavapipe", "gl-egl", "gl-zink", "gl-glsl", "gl-softpipe", "vk-swiftshader"},
      {"naive",          "refined",   "dda",         "dda_8_0",         "dda_8_4",
       "dda_8_4_dither", "dda_32_0",  "dda_32_4",    "dda_32_4_dither", "hiz",
       "naive_32",       "naive_128", "world",       "world_32",        "world_128",
       "exponential",    "adaptive",  "homogeneous", "capped",          "walk"}};
  const auto tests = loadExpectations(folder, known);
  ASSERT_TRUE(tests.has_value()) << sentence(tests.error());
  EXPECT_GE(tests->size(), 16U);
}

TEST(ReadExpectations, MetricsOfTheGeometryNeedTheirClassesAndVerdicts) {
  const auto with = [](const std::string& lines) {
    return changedTest("metric = \"different_rays\"\n", lines + "max = 1\n");
  };
  EXPECT_EQ(testComplaint(with("metric = \"true_class_share\"\ntrue_classes = [\"SKY\"]\n")), "read");
  EXPECT_EQ(testComplaint(with("metric = \"true_verdict_share\"\nverdicts = [\"TRUE_HIT\"]\n")), "read");
  EXPECT_EQ(testComplaint(with("metric = \"hit_position_px\"\ntruth = \"geometry\"\n")), "read");
  EXPECT_TRUE(says(testComplaint(with("metric = \"true_class_share\"\n")), {"true_classes"}));
  EXPECT_TRUE(says(testComplaint(with("metric = \"true_class_share\"\ntrue_classes = [\"SKYE\"]\n")),
                   {"did you mean 'SKY'"}));
  EXPECT_TRUE(says(testComplaint(with("metric = \"true_verdict_share\"\n")), {"verdicts"}));
  EXPECT_TRUE(says(testComplaint(with("metric = \"true_verdict_share\"\nverdicts = [\"MISSED\"]\n")),
                   {"MISSED_HIT"}));
  EXPECT_TRUE(says(testComplaint(with("metric = \"different_rays\"\ntruth = \"geometry\"\n")),
                   {"cannot be held against"}));
  EXPECT_TRUE(
      says(testComplaint(with("metric = \"relative_error\"\nbuffer = \"lit\"\ntruth = \"geometry\"\n")),
           {"it knows dist_view alone"}));
}

}  // namespace
}  // namespace ssrkit
