// Every metric of images passes at its bound and fails one unit beyond it.
#include <gtest/gtest.h>

#include <cmath>

#include "made_answers.h"
#include "not_finite.h"

namespace ssrkit {
namespace {

// One image of two devices, of one value each until a test changes texels.
struct TwoPictures : Bench {
  TwoPictures(const std::string& buffer, float your_value, float true_value)
      : yours(setImage(add("", shiftedRecord(kMadeSize), "vk-lavapipe"), buffer, your_value)),
        truth(setImage(add("", shiftedRecord(kMadeSize), "gl-osmesa"), buffer, true_value)) {}
  Image& yours;
  Image& truth;
};

TEST(Identical, ImagesAreComparedBitByBit) {
  TwoPictures bench("lit", 1.0F, 1.0F);
  const Expectation same =
      expectation("metric = \"identical\"\nbuffer = \"lit\"\ntruth = \"cross:gl-osmesa\"");
  EXPECT_EQ(outcomeName(bench.check(same)), "pass");
  bench.yours.at(3, 3) = std::nextafter(1.0F, 2.0F);
  EXPECT_EQ(outcomeName(bench.check(same)), "fail");
  bench.answers[1].images.clear();
  EXPECT_EQ(outcomeName(bench.check(same)), "error");
}

TEST(RelativeError, IsOfTheTruthAndNeverForgivesNaN) {
  TwoPictures bench("dist_view", 4.0F, 4.0F);
  const std::string keys = "buffer = \"dist_view\"\ntruth = \"cross:gl-osmesa\"\n";
  const Expectation relative = expectation("metric = \"relative_error\"\n" + keys + "max = 0.125");
  const Expectation absolute = expectation("metric = \"absolute_error\"\n" + keys + "max = 0.5");
  bench.yours.at(1, 1) = 4.5F;
  EXPECT_EQ(outcomeName(bench.check(relative)), "pass");
  EXPECT_EQ(outcomeName(bench.check(absolute)), "pass");
  bench.yours.at(1, 1) = 4.5001F;
  EXPECT_EQ(outcomeName(bench.check(relative)), "fail");
  EXPECT_EQ(outcomeName(bench.check(absolute)), "fail");
  bench.yours.at(1, 1) = kInfinity;
  bench.truth.at(1, 1) = kInfinity;
  EXPECT_EQ(outcomeName(bench.check(relative)), "pass");
  bench.yours.at(1, 1) = kNaN;
  EXPECT_EQ(outcomeName(bench.check(relative)), "fail");
}

TEST(RelativeError, ThePercentileIsOfAllPixels) {
  TwoPictures bench("dist_view", 4.0F, 4.0F);
  const Expectation half = expectation(
      "metric = \"relative_error\"\nbuffer = \"dist_view\"\ntruth = \"cross:gl-osmesa\"\npercentile = "
      "50.0\nmax = 0.0");
  bench.yours.at(1, 1) = 5.0F;
  bench.yours.at(2, 1) = 5.0F;
  EXPECT_EQ(outcomeName(bench.check(half)), "pass");  // 62 of 64 are right
}

TEST(RelativeError, IsAShareOfTheTruthNotOfTheAnswer) {
  TwoPictures bench("dist_view", 8.0F, 4.0F);
  const Expectation one = expectation(
      "metric = \"relative_error\"\nbuffer = \"dist_view\"\ntruth = \"cross:gl-osmesa\"\nmax = 0.99");
  EXPECT_EQ(outcomeName(bench.check(one)), "fail");  // 8 is twice 4
}

TEST(RelativeError, TheWorstChannelCounts) {
  Bench bench;
  Image yours(kMadeSize, {"R", "G", "B"});
  Image truth = yours;
  yours.at(3, 3, 2) = 1.0F;
  bench.add("", shiftedRecord(kMadeSize), "vk-lavapipe").images["lit"] = &yours;
  bench.add("", shiftedRecord(kMadeSize), "gl-osmesa").images["lit"] = &truth;
  const Expectation absolute =
      expectation("metric = \"absolute_error\"\nbuffer = \"lit\"\ntruth = \"cross:gl-osmesa\"\nmax = 0.5");
  EXPECT_EQ(outcomeName(bench.check(absolute)), "fail");
}

TEST(CoverageFlips, BothWaysCount) {
  TwoPictures bench("dist_view", 4.0F, 5.0F);
  const Expectation none =
      expectation("metric = \"coverage_flips\"\nbuffer = \"dist_view\"\ntruth = \"cross:gl-osmesa\"");
  EXPECT_EQ(outcomeName(bench.check(none)), "pass");
  bench.yours.at(1, 1) = kInfinity;
  EXPECT_EQ(outcomeName(bench.check(none)), "fail");
  bench.yours.at(1, 1) = 4.0F;
  bench.truth.at(2, 2) = kInfinity;
  EXPECT_EQ(outcomeName(bench.check(none)), "fail");
}

TEST(Identical, AZeroOfTheOtherSignIsAnotherZero) {
  TwoPictures bench("dist_view", 0.0F, 0.0F);
  const Expectation identical =
      expectation("metric = \"identical\"\nbuffer = \"dist_view\"\ntruth = \"cross:gl-osmesa\"");
  EXPECT_EQ(outcomeName(bench.check(identical)), "pass");
  bench.yours.at(1, 1) = -0.0F;
  EXPECT_EQ(outcomeName(bench.check(identical)), "fail");
}

}  // namespace
}  // namespace ssrkit
