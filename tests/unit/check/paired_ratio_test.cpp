// What rounds of two costs tell of their ratio, and what noise leaves open.
#include "check/paired_ratio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace ssrkit {
namespace {

// Rounds of two costs with a shared slowness (what else the machine does) and noise of each its own.
struct Rounds {
  std::vector<double> first;
  std::vector<double> second;
};

Rounds rounds(unsigned seed, std::size_t count, double true_ratio, double noise) {
  std::mt19937 random(seed);
  std::lognormal_distribution<double> shared(0.0, 0.5);
  std::lognormal_distribution<double> own(0.0, noise);
  Rounds made;
  for (std::size_t i = 0; i < count; ++i) {
    const double slowness = shared(random);
    made.first.push_back(1e7 * true_ratio * slowness * own(random));
    made.second.push_back(1e7 * slowness * own(random));
  }
  return made;
}

std::size_t countOutcome(Outcome wanted, double true_ratio, double noise, double max,
                         std::size_t count = 15) {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Rounds made = rounds(seed, count, true_ratio, noise);
    const auto ratio = pairedRatio(made.first, made.second);
    found += ratio && judgeRatio(*ratio, std::nullopt, max, 0.05) == wanted ? 1U : 0U;
  }
  return found;
}

TEST(PairedRatio, TheIntervalRunsBetweenTheOrderStatisticsOfTheBinomial) {
  // For 15 rounds P(at most 2 below the median) = 121/32768 = 0.37 %, at most 3: 1.76 %. So 3 are left out on
  // each side for 99 %.
  std::vector<double> numerators;
  for (int i = 15; i >= 1; --i) {
    numerators.push_back(i);
  }
  const std::vector<double> ones(15, 1.0);
  const auto ratio = pairedRatio(numerators, ones);
  ASSERT_TRUE(ratio.has_value());
  EXPECT_EQ(ratio->median, 8.0);
  EXPECT_EQ(ratio->low, 3.0);
  EXPECT_EQ(ratio->high, 13.0);
}

TEST(PairedRatio, EightRoundsAreTheFewest) {
  const std::vector<double> ones(8, 1.0);
  EXPECT_TRUE(pairedRatio(ones, ones).has_value());
  EXPECT_FALSE(pairedRatio(std::span(ones).first(7), std::span(ones).first(7)).has_value());
}

TEST(PairedRatio, ARoundWithoutCpuTimeSettlesNothing) {
  const std::vector<double> ones(9, 1.0);
  std::vector<double> zero = ones;
  zero[4] = 0.0;
  EXPECT_FALSE(pairedRatio(ones, zero).has_value());
}

TEST(PairedRatio, WhatSlowsBothSidesDownCancels) {
  const Rounds made = rounds(1, 15, 0.5, 0.0);
  const auto ratio = pairedRatio(made.first, made.second);
  ASSERT_TRUE(ratio.has_value());
  EXPECT_NEAR(ratio->low, 0.5, 1e-12);
  EXPECT_NEAR(ratio->high, 0.5, 1e-12);
}

TEST(PairedRatio, IdenticalWorkNeverFailsABoundOfOne) {
  for (const double noise : {0.001, 0.02, 0.1, 0.5}) {
    EXPECT_EQ(countOutcome(Outcome::kFail, 1.0, noise, 1.0), 0U) << noise;
  }
}

TEST(PairedRatio, ATrueDifferenceIsSeenThroughNoise) {
  EXPECT_GE(countOutcome(Outcome::kPass, 0.15, 0.05, 0.2), 999U);
  EXPECT_GE(countOutcome(Outcome::kFail, 0.3, 0.05, 0.2), 999U);
}

TEST(PairedRatio, NoiseLargerThanTheDistanceIsInconclusive) {
  EXPECT_GE(countOutcome(Outcome::kInconclusive, 0.2, 0.3, 0.2), 980U);
}

TEST(MedianInterval, RunsBetweenTheSameOrderStatistics) {
  std::vector<double> samples_ms;
  for (int i = 15; i >= 1; --i) {
    samples_ms.push_back(i);
  }
  const auto interval = medianInterval(samples_ms);
  ASSERT_TRUE(interval.has_value());
  EXPECT_EQ(interval->median, 8.0);
  EXPECT_EQ(interval->low, 3.0);
  EXPECT_EQ(interval->high, 13.0);
  EXPECT_FALSE(medianInterval(std::span(samples_ms).first(7)).has_value());
}

// Worked out with whole numbers of any length: the most that may be left out on a side, so that P(at most
// that many of n below the median) <= 0.005, and <= 0.00005. The normal approximation says the same, n / 2 -
// 0.5 - 2.5758 (3.8906) * sqrt(n) / 2.
TEST(MedianInterval, IsAsWideForManyRoundsAsTheBinomialSays) {
  struct Known {
    std::size_t count;
    double outside;
    double surely_outside;
  };
  for (const Known& known : {Known{1074, 494, 472}, Known{1075, 494, 473}, Known{1100, 506, 485},
                             Known{1200, 554, 532}, Known{2000, 941, 912}}) {
    std::vector<double> samples(known.count);
    std::iota(samples.begin(), samples.end(), 0.0);
    const auto last = static_cast<double>(known.count - 1);
    const auto interval = medianInterval(samples);
    ASSERT_TRUE(interval.has_value());
    EXPECT_EQ(interval->low, known.outside) << known.count;
    EXPECT_EQ(interval->high, last - known.outside) << known.count;
    EXPECT_EQ(interval->sure_low, known.surely_outside) << known.count;
    const auto n = static_cast<double>(known.count);
    EXPECT_NEAR(known.outside, n / 2.0 - 0.5 - 2.5758 * std::sqrt(n) / 2.0, 1.0);
    EXPECT_NEAR(known.surely_outside, n / 2.0 - 0.5 - 3.8906 * std::sqrt(n) / 2.0, 1.0);
  }
}

TEST(UnpairedRatio, EachSideMayLieAnywhereInItsOwnInterval) {
  // 99.5 % each: P(at most 2 of 15 below the median) = 121/32768 = 0.37 % is more than the 0.25 % that each
  // tail may have, P(at most 1) = 0.05 % is not. So 2 are left out on each side.
  std::vector<double> numerators;
  for (int i = 1; i <= 15; ++i) {
    numerators.push_back(i);
  }
  const std::vector<double> twos(15, 2.0);
  const auto ratio = unpairedRatio(numerators, twos);
  ASSERT_TRUE(ratio.has_value());
  EXPECT_EQ(ratio->median, 4.0);
  EXPECT_EQ(ratio->low, 1.0);
  EXPECT_EQ(ratio->high, 7.0);
  const auto turned = unpairedRatio(twos, numerators);
  ASSERT_TRUE(turned.has_value());
  EXPECT_EQ(turned->low, 2.0 / 14.0);
  EXPECT_EQ(turned->high, 1.0);
}

TEST(UnpairedRatio, HoldsTheTrueRatioAsOftenAsItSays) {
  constexpr int kTrials = 2000;
  int held = 0;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    std::mt19937 random(seed);
    std::lognormal_distribution<double> noise(0.0, 0.2);
    std::vector<double> now(15);
    std::vector<double> then(15);
    std::ranges::generate(now, [&] { return 1.3 * noise(random); });
    std::ranges::generate(then, [&] { return noise(random); });
    const RatioInterval ratio = unpairedRatio(now, then).value();
    held += ratio.low <= 1.3 && ratio.high >= 1.3 ? 1 : 0;
  }
  EXPECT_GE(held, kTrials * 99 / 100);
}

TEST(JudgeRatio, TheWholeIntervalMustHoldOrBreakTheBound) {
  EXPECT_EQ(judgeRatio({0.19, 0.18, 0.2, 0.1, 0.3}, std::nullopt, 0.2, 0.05), Outcome::kPass);
  EXPECT_EQ(judgeRatio({0.19, 0.18, 0.2001, 0.1, 0.3}, std::nullopt, 0.2, 0.05), Outcome::kInconclusive);
  EXPECT_EQ(judgeRatio({0.25, 0.22, 0.3, 0.2101, 0.4}, std::nullopt, 0.2, 0.05), Outcome::kFail);
  EXPECT_EQ(judgeRatio({0.25, 0.22, 0.3, 0.2099, 0.4}, std::nullopt, 0.2, 0.05), Outcome::kInconclusive);
  EXPECT_EQ(judgeRatio({5.0, 4.0, 6.0, 3.0, 7.0}, 4.0, std::nullopt, 0.0), Outcome::kPass);
  EXPECT_EQ(judgeRatio({3.0, 2.0, 3.8, 1.0, 3.9}, 4.0, std::nullopt, 0.0), Outcome::kFail);
}

TEST(JudgeRatio, FewerThanFifteenRoundsMayAcquitButNeverAccuse) {
  const std::vector<double> threes(14, 3.0);
  const std::vector<double> ones(14, 1.0);
  const RatioInterval ratio = pairedRatio(threes, ones).value();
  EXPECT_EQ(judgeRatio(ratio, std::nullopt, 1.0, 0.05), Outcome::kInconclusive);
  EXPECT_EQ(judgeRatio(ratio, std::nullopt, 3.0, 0.05), Outcome::kPass);
}

}  // namespace
}  // namespace ssrkit
