#include "conform/isolate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "made_records.h"

namespace ssrkit {
namespace {

Cell cellOf(int number) {
  return {"t", "scene" + std::to_string(number), {64, 36}, "gl-a"};
}

std::vector<Cell> cellsBefore(int count) {
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    cells.push_back(cellOf(i));
  }
  return cells;
}

const Cell kCell = {"t", "it", {64, 36}, "gl-a"};

// A driver by rule: whether the cell fails after `before`, the n-th time that it is run apart.
struct Driver {
  std::function<bool(std::span<const Cell> before, int run)> fails;
  int runs = 0;

  RunApart runner() {
    return [this](const Cell&, std::span<const Cell> before) {
      return std::vector{madeCheck("t.rays", fails(before, ++runs) ? Outcome::kFail : Outcome::kPass),
                         madeCheck("t.other", Outcome::kPass)};
    };
  }
};

std::vector<CheckResult> failed() {
  return {madeCheck("t.rays", Outcome::kFail), madeCheck("t.other", Outcome::kPass)};
}

bool holds(std::span<const Cell> before, int number) {
  return std::ranges::find(before, cellOf(number)) != before.end();
}

TEST(Isolate, WhatPassedIsNotRunAgain) {
  Driver driver{[](auto, int) { return true; }};
  const auto isolated =
      isolate(kCell, {madeCheck("t.rays", Outcome::kPass)}, cellsBefore(3), driver.runner());
  EXPECT_EQ(0, driver.runs);
  EXPECT_EQ(0, isolated.extra_runs);
  EXPECT_EQ(Outcome::kPass, isolated.checks[0].outcome);
}

TEST(Isolate, WhatFailsAgainAloneIsAFailure) {
  Driver driver{[](auto, int) { return true; }};
  const auto isolated = isolate(kCell, failed(), cellsBefore(3), driver.runner());
  EXPECT_EQ(1, driver.runs) << "one run says enough";
  EXPECT_EQ(Outcome::kFail, isolated.checks[0].outcome);
  EXPECT_EQ(std::string::npos, isolated.checks[0].message.find("flake"));
}

TEST(Isolate, WhatPassesAloneAndCannotBeBroughtBackIsAFlake) {
  Driver driver{[](auto, int) { return false; }};
  const auto isolated = isolate(kCell, failed(), cellsBefore(100), driver.runner());
  EXPECT_EQ(Outcome::kFlake, isolated.checks[0].outcome);
  EXPECT_NE(std::string::npos, isolated.checks[0].message.find("was fail once"));
  EXPECT_EQ(Outcome::kPass, isolated.checks[1].outcome);
}

TEST(Isolate, WhatFailsNowAndThenAloneIsAFlakeAndNoOrder) {
  Driver driver{[](auto, int run) { return run == 2; }};
  const auto isolated = isolate(kCell, failed(), cellsBefore(100), driver.runner());
  EXPECT_EQ(Outcome::kFlake, isolated.checks[0].outcome);
  EXPECT_EQ(2, driver.runs) << "a list is not halved for what fails by chance";
}

TEST(Isolate, NamesTheOneCellThatItDependsOn) {
  for (const int culprit : {0, 1, 57, 92, 99}) {
    Driver driver{[&](auto before, int) { return holds(before, culprit); }};
    const auto isolated = isolate(kCell, failed(), cellsBefore(100), driver.runner());
    EXPECT_EQ(Outcome::kFail, isolated.checks[0].outcome) << culprit;
    const std::string& message = isolated.checks[0].message;
    EXPECT_NE(std::string::npos, message.find("fails after " + cellId(cellOf(culprit)) + "\n")) << message;
    EXPECT_NE(std::string::npos,
              message.find("--filter " + cellId(cellOf(culprit)) + " --filter " + cellId(kCell)));
    EXPECT_LE(driver.runs, 24) << "halving, not one after another";
    EXPECT_EQ(driver.runs, isolated.extra_runs);
  }
}

TEST(Isolate, SaysWhenItTakesSeveralCells) {
  Driver driver{[](auto before, int) { return holds(before, 2) && holds(before, 7); }};
  const auto isolated = isolate(kCell, failed(), cellsBefore(8), driver.runner());
  EXPECT_EQ(Outcome::kFail, isolated.checks[0].outcome);
  EXPECT_NE(std::string::npos, isolated.checks[0].message.find("cells behind it"));
}

TEST(Isolate, AWorkerThatDiedOnceIsAFlakeAndItsChecksAreTheLaterOnes) {
  Driver driver{[](auto, int) { return false; }};
  CheckResult crash = madeCheck("t.runs", Outcome::kCrash);
  crash.stage = "";
  const auto isolated = isolate(kCell, {crash}, {}, driver.runner());
  ASSERT_EQ(3U, isolated.checks.size());
  EXPECT_EQ(Outcome::kFlake, isolated.checks[0].outcome);
  EXPECT_NE(std::string::npos, isolated.checks[0].message.find("was crash once"));
  EXPECT_EQ(Outcome::kPass, isolated.checks[1].outcome);
}

TEST(Isolate, AWorkerThatDiesAgainIsACrashAndNothingElse) {
  CheckResult crash = madeCheck("t.runs", Outcome::kCrash);
  const auto isolated =
      isolate(kCell, {crash}, cellsBefore(3), [&](const Cell&, auto) { return std::vector{crash}; });
  ASSERT_EQ(1U, isolated.checks.size());
  EXPECT_EQ(Outcome::kCrash, isolated.checks[0].outcome);
  EXPECT_EQ(1, isolated.extra_runs);
}

TEST(Isolate, OneCheckMayBeAFlakeWhileAnotherFails) {
  auto checks = failed();
  checks[1].outcome = Outcome::kFail;
  const auto isolated = isolate(kCell, checks, {}, [](const Cell&, auto) {
    return std::vector{madeCheck("t.rays", Outcome::kPass), madeCheck("t.other", Outcome::kFail)};
  });
  EXPECT_EQ(Outcome::kFlake, isolated.checks[0].outcome);
  EXPECT_EQ(Outcome::kFail, isolated.checks[1].outcome);
}

TEST(Isolate, TheCommandStaysTheMessagesLastLine) {
  auto checks = failed();
  checks[0].message = "fail: t.rays\n  yours     3\n  again     ./ssrkit conform --filter x";
  Driver driver{[](auto, int) { return false; }};
  const auto isolated = isolate(kCell, checks, {}, driver.runner());
  EXPECT_TRUE(isolated.checks[0].message.ends_with("\n  again     ./ssrkit conform --filter x"));
}

}  // namespace
}  // namespace ssrkit
