// Every metric of rays passes at its bound and fails one unit beyond it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "made_answers.h"

namespace ssrkit {
namespace {

// One stage's answer and the oracle's, equal until a test changes one.
struct AgainstOracle : Bench {
  AgainstOracle() {
    Answer& answer = add("hiz", shiftedRecord(kMadeSize));
    setOracle(answer, shiftedRecord(kMadeSize));
    setWorld(answer, 4.0F);
  }
  RayHit& ray(std::size_t i) { return records.front().rays[i]; }
  RayHit& truth(std::size_t i) { return oracles.front().record.rays[i]; }
};

TEST(DifferentRays, OneRayMoreThanTheBoundFails) {
  AgainstOracle bench;
  const Expectation none = expectation("metric = \"different_rays\"");
  EXPECT_EQ(outcomeName(bench.check(none)), "pass");
  bench.ray(5).texel_x += 1;
  EXPECT_EQ(outcomeName(bench.check(none)), "fail");
  EXPECT_EQ(bench.check(none).value, 1.0);
  const Expectation one = expectation("metric = \"different_rays\"\nmax = 1");
  EXPECT_EQ(outcomeName(bench.check(one)), "pass");
  bench.ray(6) = without(RayClass::kRange);
  EXPECT_EQ(outcomeName(bench.check(one)), "fail");
}

TEST(DifferentRays, TiesAreLeftOutAndCounted) {
  AgainstOracle bench;
  bench.ray(5).texel_x += 1;
  bench.oracles.front().ambiguity[5] = Ambiguity::kDepth;
  const CheckResult result = bench.check(expectation("metric = \"different_rays\""));
  EXPECT_EQ(outcomeName(result), "pass");
  EXPECT_NE(result.message.find("1 rays are ties"), std::string::npos) << result.message;
}

TEST(DifferentRays, WithoutATruthTheCheckIsAnError) {
  AgainstOracle bench;
  bench.answers[0].oracle = nullptr;
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"different_rays\""))), "error");
  const Expectation stage = expectation("metric = \"different_rays\"\ntruth = \"stage:walk\"");
  EXPECT_EQ(outcomeName(bench.check(stage)), "error");
  bench.add("walk", shiftedRecord({16, 16}));
  EXPECT_EQ(outcomeName(bench.check(stage)), "error");  // of another size
  bench.add("walk", shiftedRecord(kMadeSize));
  EXPECT_EQ(outcomeName(bench.check(stage)), "pass");
  bench.records.back().rays[0].texel_y += 1;
  EXPECT_EQ(outcomeName(bench.check(stage)), "fail");
  bench.answers[0].record = nullptr;
  EXPECT_EQ(outcomeName(bench.check(stage)), "error");
}

TEST(DifferentRays, AnImageWithoutARayFailsUnlessItIsAllowed) {
  Bench bench;
  const RayRecord masked{kMadeSize, std::vector<RayHit>(64, without(RayClass::kMasked))};
  bench.setOracle(bench.add("hiz", masked), masked);
  const CheckResult result = bench.check(expectation("metric = \"different_rays\""));
  EXPECT_EQ(outcomeName(result), "fail");
  EXPECT_NE(result.message.find("no ray was compared"), std::string::npos);
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"different_rays\"\nallow_empty = true"))), "pass");
}

TEST(AmbiguousShare, OneTieMoreThanTheBoundFails) {
  AgainstOracle bench;
  const Expectation two = expectation("metric = \"ambiguous_share\"\nmax = 0.03125");  // 2 of 64
  bench.oracles.front().ambiguity[1] = Ambiguity::kEnd;
  bench.oracles.front().ambiguity[2] = Ambiguity::kEnd;
  EXPECT_EQ(outcomeName(bench.check(two)), "pass");
  bench.oracles.front().ambiguity[3] = Ambiguity::kPosition;
  EXPECT_EQ(outcomeName(bench.check(two)), "fail");
}

TEST(VerdictCount, OnlyTheNamedVerdictsCount) {
  AgainstOracle bench;
  const Expectation wrong = expectation("metric = \"verdict_count\"\nverdicts = [\"WRONG\", \"FALSE_HIT\"]");
  const Expectation near = expectation("metric = \"verdict_share\"\nverdicts = [\"NEAR\"]\nmax = 0.015625");
  bench.ray(9).texel_x = 2;  // the truth's is 1
  EXPECT_EQ(outcomeName(bench.check(wrong)), "pass");
  EXPECT_EQ(outcomeName(bench.check(near)), "pass");
  bench.ray(10).texel_x = 3;
  EXPECT_EQ(outcomeName(bench.check(near)), "fail");
  bench.truth(11) = without(RayClass::kOffscreen);
  const CheckResult result = bench.check(wrong);
  EXPECT_EQ(outcomeName(result), "fail");
  EXPECT_NE(result.message.find("NEAR 2"), std::string::npos) << result.message;
}

TEST(VerdictGain, IsTheShareThatTheOtherLacks) {
  Bench bench;
  RayRecord worse = shiftedRecord({8, 8});
  for (std::size_t i = 0; i < 16; ++i) {
    worse.rays[i].texel_x += 1;
  }
  bench.setWorld(bench.add("hiz", shiftedRecord({8, 8})), 5.0F);
  bench.setWorld(bench.add("walk", worse), 5.0F);
  for (Answer& answer : bench.answers) {
    bench.setOracle(answer, shiftedRecord({8, 8}));
  }
  const std::string gain =
      "metric = \"verdict_gain\"\nverdicts = [\"SAME\"]\nstages = [\"hiz\"]\ntruth = \"stage:walk\"\n";
  const CheckResult check = bench.check(expectation(gain + "min = 0.25"));
  EXPECT_EQ(check.value, 0.25);
  EXPECT_EQ(outcomeName(check), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation(gain + "min = 0.26"))), "fail");
  bench.answers[1].oracle = nullptr;
  EXPECT_EQ(outcomeName(bench.check(expectation(gain + "min = 0"))), "error");
}

TEST(HitPosition, TheLargestOrAPercentileOfTheDistance) {
  AgainstOracle bench;
  bench.ray(3).px_x += 0.25F;
  const auto bound = [](const char* keys) {
    return expectation(std::string("metric = \"hit_position_px\"\n") + keys);
  };
  EXPECT_EQ(outcomeName(bench.check(bound("max = 0.25"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(bound("max = 0.2499"))), "fail");
  EXPECT_EQ(outcomeName(bench.check(bound("max = 0.0\npercentile = 98.0"))), "pass");  // 63 of 64 are exact
  EXPECT_EQ(outcomeName(bench.check(bound("max = 0.0\npercentile = 99.0"))),
            "fail");  // the 64th: ranks are rounded up
  bench.ray(4).px_y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(outcomeName(bench.check(bound("max = 1e9"))), "fail");
}

TEST(ClosedForm, TheFormulaOfM1MovesOneRowAndTheCheckFails) {
  Bench bench;
  const Size size{256, 256};
  RayRecord record{size, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      // Rows from the top: the floor meets the wall at row 160, and row y shows row 319 - y.
      RayHit ray = y >= 160 ? hitAt(x, 319 - y, static_cast<std::uint32_t>(y - (319 - y)))
                            : without(RayClass::kMasked);
      record.rays.push_back(ray);
    }
  }
  bench.add("walk", record).size = size;
  const Expectation form = expectation("metric = \"closed_form\"");
  const CheckResult good = bench.check(form, 0, "m1");
  EXPECT_EQ(outcomeName(good), "pass") << good.message;
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"closed_form_lookups\""), 0, "m1")), "pass");
  RayRecord& kept = bench.records.front();
  kept.rays[200 * 256 + 7].lookups += 1;
  EXPECT_EQ(outcomeName(bench.check(form, 0, "m1")), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"closed_form_lookups\""), 0, "m1")), "fail");
  kept.rays[200 * 256 + 7].texel_y += 1;
  EXPECT_EQ(outcomeName(bench.check(form, 0, "m1")), "fail");
  EXPECT_EQ(outcomeName(bench.check(form, 0, "clutter")), "error");
}

TEST(Identical, AnyBitOfTheRecordCountsUnlessItsFieldIsIgnored) {
  Bench bench;
  bench.add("hiz", shiftedRecord(kMadeSize), "vk-lavapipe");
  bench.add("hiz", shiftedRecord(kMadeSize), "gl-osmesa");
  const Expectation all = expectation("metric = \"identical\"\ntruth = \"cross:gl-osmesa\"");
  const Expectation most =
      expectation("metric = \"identical\"\ntruth = \"cross:gl-osmesa\"\nignore = [\"lookups\", \"steps\"]");
  EXPECT_EQ(outcomeName(bench.check(all)), "pass");
  RayHit& ray = bench.records.front().rays[12];
  ray.lookups += 1;
  EXPECT_EQ(outcomeName(bench.check(all)), "fail");
  EXPECT_EQ(outcomeName(bench.check(most)), "pass");
  ray.t_m = std::nextafter(ray.t_m, 2.0F);
  EXPECT_EQ(outcomeName(bench.check(most)), "fail");
  bench.answers[1].device = "vk-swiftshader";
  EXPECT_EQ(outcomeName(bench.check(most)), "error");
}

TEST(DifferentRays, MissesOfDifferentClassesDiffer) {
  Bench bench;
  bench.add("hiz", shiftedRecord(kMadeSize), "vk-lavapipe");
  bench.add("hiz", shiftedRecord(kMadeSize), "gl-osmesa");
  const Expectation none = expectation("metric = \"different_rays\"\ntruth = \"cross:gl-osmesa\"");
  bench.records[0].rays[3] = without(RayClass::kRange);
  bench.records[1].rays[3] = without(RayClass::kRange);
  EXPECT_EQ(outcomeName(bench.check(none)), "pass");
  bench.records[1].rays[3] = without(RayClass::kOffscreen);
  EXPECT_EQ(outcomeName(bench.check(none)), "fail");
}

TEST(MaskFlips, AreCountedPerMillionPixels) {
  Bench bench;
  bench.add("hiz", shiftedRecord(kMadeSize), "vk-lavapipe");
  bench.add("hiz", shiftedRecord(kMadeSize), "gl-osmesa");
  const Expectation one = expectation(
      "metric = \"mask_flips_per_million\"\ntruth = \"cross:gl-osmesa\"\nmax = 15625");  // 1 of 64
  bench.records.front().rays[3] = without(RayClass::kRange);
  EXPECT_EQ(outcomeName(bench.check(one)), "pass");
  bench.records.front().rays[4] = without(RayClass::kRange);
  EXPECT_EQ(outcomeName(bench.check(one)), "fail");
}

TEST(HitPosition, AHitInAnotherTexelCountsAgainstAnotherCase) {
  const std::string cases = "[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n";
  const Expectation moved =
      expectation("metric = \"hit_position_px\"\ntruth = \"case:a\"\npercentile = 90\nmax = 0.5", cases);
  Bench bench;
  bench.add("hiz", shiftedRecord(kMadeSize), "gl-osmesa", "a");
  bench.add("hiz", shiftedRecord(kMadeSize), "gl-osmesa", "b");
  EXPECT_EQ(outcomeName(bench.check(moved, 1)), "pass");
  for (std::size_t i = 0; i < 58; ++i) {  // nine in ten
    bench.records.back().rays[i].texel_x += 10;
    bench.records.back().rays[i].px_x += 10.0F;
  }
  EXPECT_EQ(outcomeName(bench.check(moved, 1)), "fail");
  EXPECT_EQ(bench.check(moved, 1).value, 10.0);
}

TEST(FoundShare, CountsTheOraclesHitsWithinTwoPixels) {
  Bench bench;
  RayRecord yours = shiftedRecord({8, 8});
  const RayRecord oracle = yours;
  yours.rays[0].px_x += 2.0F;                     // found
  yours.rays[1].px_x += 2.25F;                    // elsewhere
  yours.rays[2] = without(RayClass::kOffscreen);  // missed
  bench.setOracle(bench.add("hiz", yours), oracle);
  const CheckResult check = bench.check(expectation("metric = \"found_share\"\nmin = 0.96875"));
  EXPECT_EQ(check.value, 62.0 / 64.0);
  EXPECT_EQ(outcomeName(check), "pass");
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"found_share\"\nmin = 0.97"))), "fail");
}

}  // namespace
}  // namespace ssrkit
