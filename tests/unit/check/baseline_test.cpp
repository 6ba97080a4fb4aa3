#include "check/baseline.h"

#include <gtest/gtest.h>

#include "check/read_baseline.h"

namespace ssrkit {
namespace {

using std::chrono::sys_days;
using std::chrono::year;

constexpr sys_days kToday = year(2026) / 6 / 15;

const std::string kEntry =
    "[[expected_failure]]\n"
    "id = \"cross.depth.*\"\n"
    "device = \"vk-swiftshader\"\n"
    "driver = \"SwiftShader 5\"\n"
    "outcome = [\"fail\"]\n"
    "reason = \"depth is rounded down\"\n"
    "expires = \"2026-06-15\"\n"
    "bug = \"docs/driver-bugs.md#rounds-down\"\n";

std::vector<KnownFailure> baseline(const std::string& content = kEntry) {
  auto entries = readBaseline(content, "known.toml");
  EXPECT_TRUE(entries) << sentence(entries.error());
  return entries.value_or(std::vector<KnownFailure>{});
}

CheckResult check(Outcome outcome, const std::string& device = "vk-swiftshader") {
  CheckResult result{.id = "cross.depth.ulps", .scene = "m1", .device = device, .size = {64, 32}};
  result.outcome = outcome;
  result.message = "as it was";
  return result;
}

const DeviceTexts kDevices = {{"vk-swiftshader", "Vulkan 1.3 SwiftShader 5.0.0 Subzero"},
                              {"vk-lavapipe", "Vulkan 1.3 llvmpipe Mesa 22.3.6"}};

std::string baselineComplaint(const std::string& content, const KnownNames& known = {}) {
  const auto entries = readBaseline(content, "known.toml", known);
  return entries ? "" : sentence(entries.error());
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kEntry;
  return text.replace(text.find(from), from.size(), to);
}

TEST(Baseline, AnExpectedFailureIsExcusedWithItsReason) {
  std::vector<CheckResult> checks = {check(Outcome::kFail)};
  EXPECT_TRUE(applyBaseline(baseline(), kDevices, kToday, checks).empty());
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_STREQ(name(checks[0].outcome), "xfail");
  EXPECT_EQ(
      checks[0].message,
      "expected fail: depth is rounded down (docs/driver-bugs.md#rounds-down, until 2026-06-15)\nas it was");
}

TEST(Baseline, WhatPassesAlthoughItIsListedFailsTheRun) {
  for (const Outcome outcome : {Outcome::kPass, Outcome::kWarn}) {
    std::vector<CheckResult> checks = {check(outcome)};
    EXPECT_TRUE(applyBaseline(baseline(), kDevices, kToday, checks).empty());
    EXPECT_STREQ(name(checks[0].outcome), "xpass");
    EXPECT_TRUE(isFailure(checks[0].outcome));
    EXPECT_NE(checks[0].message.find("known.toml:1:"), std::string::npos) << checks[0].message;
  }
}

TEST(Baseline, AWorseOutcomeThanTheExpectedOneIsNotExcused) {
  std::vector<CheckResult> checks = {check(Outcome::kCrash)};
  EXPECT_TRUE(applyBaseline(baseline(), kDevices, kToday, checks).empty());
  EXPECT_STREQ(name(checks[0].outcome), "crash");
  EXPECT_NE(checks[0].message.find("expects fail here, not crash"), std::string::npos) << checks[0].message;
}

TEST(Baseline, WhatWasNotJudgedStaysAsItIs) {
  for (const Outcome outcome : {Outcome::kSkip, Outcome::kInconclusive, Outcome::kFlake}) {
    std::vector<CheckResult> checks = {check(outcome)};
    EXPECT_TRUE(applyBaseline(baseline(), kDevices, kToday, checks).empty());
    EXPECT_EQ(checks[0].outcome, outcome);
    EXPECT_EQ(checks[0].message, "as it was");
  }
}

TEST(Baseline, EveryPatternMustFit) {
  const std::pair<std::string, std::string> changes[] = {
      {"cross.depth.*", "cross.normal.*"},   {"\"vk-swiftshader\"", "\"vk-lava*\""},
      {"SwiftShader 5", "SwiftShader 6"},    {"reason", "scene = \"m2\"\nreason"},
      {"reason", "stage = \"hiz\"\nreason"}, {"reason", "case = \"t_1m\"\nreason"},
      {"reason", "size = \"64x33\"\nreason"}};
  for (const auto& [from, to] : changes) {
    std::vector<CheckResult> checks = {check(Outcome::kFail)};
    const std::vector<KnownFailure> entries = baseline(replaced(from, to));
    const auto unused = applyBaseline(entries, kDevices, kToday, checks);
    EXPECT_EQ(checks[0].outcome, Outcome::kFail) << to;
    ASSERT_EQ(unused.size(), 1U) << to;
    EXPECT_EQ(unused[0], entries.data());
  }
  std::vector<CheckResult> checks = {check(Outcome::kFail)};
  const auto entries = baseline(replaced("reason", "scene = \"m?\"\nsize = \"64x*\"\nreason"));
  EXPECT_TRUE(applyBaseline(entries, kDevices, kToday, checks).empty());
  EXPECT_EQ(checks[0].outcome, Outcome::kXfail);
}

TEST(Baseline, AnExpiredEntryExcusesNothingAndIsNamedOnce) {
  std::vector<CheckResult> checks = {check(Outcome::kFail), check(Outcome::kFail), check(Outcome::kPass)};
  EXPECT_TRUE(applyBaseline(baseline(), kDevices, kToday + std::chrono::days(1), checks).empty());
  ASSERT_EQ(checks.size(), 4U);
  EXPECT_EQ(checks[0].outcome, Outcome::kFail);
  EXPECT_EQ(checks[2].outcome, Outcome::kPass);
  EXPECT_EQ(checks[3].outcome, Outcome::kError);
  EXPECT_NE(checks[3].message.find("known.toml:1:"), std::string::npos) << checks[3].message;
  EXPECT_NE(checks[3].message.find("2026-06-15"), std::string::npos) << checks[3].message;
}

TEST(Baseline, TheFirstEntryThatFitsDecidesAndTheOthersAreUsedToo) {
  std::vector<CheckResult> checks = {check(Outcome::kFail)};
  const std::string second = replaced("depth is rounded down", "another reason");
  EXPECT_TRUE(applyBaseline(baseline(kEntry + second), kDevices, kToday, checks).empty());
  EXPECT_NE(checks[0].message.find("depth is rounded down"), std::string::npos);
}

TEST(ReadBaseline, AFileMayListNothing) {
  EXPECT_TRUE(baseline("# nothing fails\n").empty());
}

TEST(ReadBaseline, WhatIsWrongIsNamedWithItsPlace) {
  EXPECT_NE(baselineComplaint(replaced("reason", "raeson")).find("known.toml:6:1"), std::string::npos);
  EXPECT_NE(baselineComplaint(replaced("reason", "raeson")).find("did you mean 'reason'?"),
            std::string::npos);
  EXPECT_NE(baselineComplaint(replaced("2026-06-15", "2026-02-30")).find("known.toml:7:"), std::string::npos);
  EXPECT_NE(baselineComplaint(replaced("2026-06-15", "15.6.2026")).find("'15.6.2026' is no date"),
            std::string::npos);
  EXPECT_NE(baselineComplaint(replaced("[\"fail\"]", "[\"pass\"]")).find("known.toml:5:"), std::string::npos);
  EXPECT_NE(
      baselineComplaint(replaced("[[expected_failure]]", "[expected_failure]")).find("[[expected_failure]]"),
      std::string::npos);
  EXPECT_NE(baselineComplaint("expected_failure = [1]").find("known.toml:1:21"), std::string::npos);
  for (const std::string key : {"id", "device", "outcome", "reason", "expires", "bug"}) {
    EXPECT_NE(baselineComplaint(replaced("\n" + key + " =", "\n# ")).find("'" + key + "'"), std::string::npos)
        << key;
  }
}

TEST(ReadBaseline, ADeviceWithoutAWildcardMustBeKnown) {
  KnownNames known;
  known.devices = {"vk-swiftshade"};
  EXPECT_NE(baselineComplaint(kEntry, known).find("did you mean 'vk-swiftshade'?"), std::string::npos);
  EXPECT_EQ(baselineComplaint(replaced("\"vk-swiftshader\"", "\"vk-*\""), known), "");
}

}  // namespace
}  // namespace ssrkit
