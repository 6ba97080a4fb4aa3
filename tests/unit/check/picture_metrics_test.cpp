// The metrics that say what somebody sees: bands between neighbours, and FLIP.
#include <gtest/gtest.h>

#include <algorithm>

#include "image/flip.h"
#include "made_answers.h"

namespace ssrkit {
namespace {

constexpr Size kRowsSize{8, 32};

// A mirror whose hit moves by a texel a row, as the truth has it; `held` rows show the same texel.
RayRecord heldRows(int held) {
  RayRecord record{kRowsSize, {}};
  for (int y = 0; y < kRowsSize.height; ++y) {
    for (int x = 0; x < kRowsSize.width; ++x) {
      record.rays.push_back(hitAt(x, 100 - y / held * held));
    }
  }
  return record;
}

const std::string kJump = "metric = \"hit_jump_px\"\nstages = [\"hiz\"]\n";

TEST(HitJump, IsWhatABandBreaksBy) {
  Bench bench;
  Answer& answer = bench.add("hiz", heldRows(4));
  bench.setOracle(answer, heldRows(1));
  // Within a band a row moves by 0 where the truth moves by 1; from band to band by 4.
  const CheckResult largest = bench.check(expectation(kJump + "max = 2.9"));
  EXPECT_DOUBLE_EQ(largest.value.value_or(0.0), 3.0);
  EXPECT_EQ(outcomeName(largest), "fail");
  EXPECT_EQ(outcomeName(bench.check(expectation(kJump + "max = 3"))), "pass");
  // 31 rows of 8 vertical pairs, 7 of them from band to band; and 32 rows of 7 horizontal pairs that do not
  // break.
  EXPECT_EQ(largest.compared, 31U * 8U + 32U * 7U);
  const double broken = 7.0 * 8.0 / static_cast<double>(largest.compared);
  EXPECT_DOUBLE_EQ(bench
                       .check(expectation(kJump + "percentile = " +
                                          std::to_string(100.0 * (1.0 - broken) - 0.1) + "\nmax = 9"))
                       .value.value_or(0.0),
                   1.0);
  EXPECT_NE(largest.remark.find("56 of 472"), std::string::npos) << largest.remark;
}

TEST(HitJump, IsNothingWhereTheAnswerIsTheTruthOrShiftedAsAWhole) {
  Bench bench;
  RayRecord shifted = heldRows(1);
  for (RayHit& hit : shifted.rays) {
    hit.px_y += 7.0F;
  }
  Answer& answer = bench.add("hiz", shifted);
  bench.setOracle(answer, heldRows(1));
  EXPECT_EQ(outcomeName(bench.check(expectation(kJump + "max = 0"))), "pass");
}

TEST(HitJump, LeavesOutWhereTheTruthBreaksItselfMissesAndTies) {
  Bench bench;
  RayRecord yours = heldRows(1);
  RayRecord truth = heldRows(1);
  truth.rays[3 * 8 + 2].px_x = 90.0F;                     // another surface
  yours.rays[9 * 8 + 2] = without(RayClass::kOffscreen);  // a miss
  yours.rays[20 * 8 + 2].px_x = 300.0F;                   // far off, but a tie
  Answer& answer = bench.add("hiz", yours);
  bench.setOracle(answer, truth).ambiguity[20 * 8 + 2] = Ambiguity::kDepth;
  const CheckResult check = bench.check(expectation(kJump + "max = 0"));
  EXPECT_EQ(outcomeName(check), "pass") << check.message;
  EXPECT_EQ(check.compared, 31U * 8U + 32U * 7U - 3U * 4U);
}

const std::string kFlip =
    "metric = \"flip\"\nbuffer = \"composite\"\nstages = [\"hiz\"]\ntruth = \"stage:walk\"\n";

TEST(FlipMetric, IsTheMeanOverThePixelsWithARay) {
  Bench bench;
  RayRecord record = heldRows(1);
  for (std::size_t pixel = 0; pixel < record.rays.size() / 2; ++pixel) {
    record.rays[pixel] = without(RayClass::kMasked);
  }
  Image* yours = &bench.setImage(bench.add("hiz", record), "composite", 0.2F);
  yours->at(4, 28) = 0.9F;
  yours->at(1, 2) = 0.9F;  // no ray there
  bench.setImage(bench.add("walk", record), "composite", 0.2F);
  Image flat(kRowsSize, {"v"});
  std::ranges::fill(flat.data, 0.2F);
  const Image map = flipMap(flat, *yours);
  const std::size_t half = map.data.size() / 2;
  double sum = 0.0;
  float worst = 0.0F;
  for (std::size_t pixel = half; pixel < map.data.size(); ++pixel) {
    sum += map.data[pixel];
    worst = std::max(worst, map.data[pixel]);
  }
  const CheckResult mean = bench.check(expectation(kFlip + "max = 0.001"));
  EXPECT_NEAR(mean.value.value_or(0.0), sum / static_cast<double>(half), 1e-9);
  EXPECT_EQ(outcomeName(mean), "fail");
  EXPECT_NEAR(bench.check(expectation(kFlip + "percentile = 100\nmax = 1")).value.value_or(0.0), worst, 1e-9);
}

TEST(FlipMetric, IsZeroForTheSamePicture) {
  Bench bench;
  bench.setImage(bench.add("hiz", heldRows(1)), "composite", 0.2F);
  bench.setImage(bench.add("walk", heldRows(1)), "composite", 0.2F);
  EXPECT_EQ(outcomeName(bench.check(expectation(kFlip + "max = 0"))), "pass");
}

}  // namespace
}  // namespace ssrkit
