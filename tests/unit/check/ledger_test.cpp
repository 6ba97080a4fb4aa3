#include "check/ledger.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "made_answers.h"
#include "not_finite.h"

namespace ssrkit {
namespace {

constexpr auto kSingle = FloatFormat::kSingle;
constexpr auto kHalf = FloatFormat::kHalf;

float next(float value, int steps = 1) {
  for (int i = 0; i < steps; ++i) {
    value = std::nextafter(value, kInfinity);
  }
  return value;
}

Image rowImage(const std::vector<float>& values) {
  Image image({static_cast<int>(values.size()), 1}, {"v"});
  image.data = values;
  return image;
}

TEST(Ledger, UlpsAreTheNumbersBetween) {
  EXPECT_EQ(ulpsBetween(1.0F, 1.0F, kSingle), 0U);
  EXPECT_EQ(ulpsBetween(1.0F, next(1.0F), kSingle), 1U);
  EXPECT_EQ(ulpsBetween(next(1000.0F, 7), 1000.0F, kSingle), 7U);
  EXPECT_EQ(ulpsBetween(-1.0F, -next(1.0F, 3), kSingle), 3U);
  EXPECT_EQ(ulpsBetween(1.0F, 2.0F, kSingle), 1U << 23U);  // all mantissas of one exponent
  EXPECT_EQ(ulpsBetween(0.0F, -0.0F, kSingle), 0U);
  const float least = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(ulpsBetween(-least, 2.0F * least, kSingle), 3U);  // -1, 0, 1, 2
}

TEST(Ledger, UlpsOfHalvesAreCountedInHalves) {
  EXPECT_EQ(ulpsBetween(1.0F, 1.0F + 0x1p-10F, kHalf), 1U);
  EXPECT_EQ(ulpsBetween(1.0F, 2.0F, kHalf), 1024U);
  EXPECT_EQ(ulpsBetween(0.0F, 0x1p-24F, kHalf), 1U);  // the least subnormal half
  EXPECT_EQ(ulpsBetween(0x1p-14F - 0x1p-24F, 0x1p-14F, kHalf),
            1U);  // the last subnormal and the first normal
  EXPECT_EQ(ulpsBetween(0x1p-14F, 0x1p-14F + 0x1p-24F, kHalf), 1U);  // both normal
  EXPECT_EQ(ulpsBetween(-0x1p-24F, 0x1p-24F, kHalf), 2U);
  EXPECT_EQ(ulpsBetween(0.0F, 65504.0F, kHalf), 0x7BFFU);  // the largest half's own bits
}

TEST(Ledger, BinsHoldWhatTheySay) {
  EXPECT_EQ(ulpBin(0), 0U);
  EXPECT_EQ(ulpBin(4), 4U);
  EXPECT_EQ(ulpBin(5), 5U);
  EXPECT_EQ(ulpBin(8), 5U);
  EXPECT_EQ(ulpBin(9), 6U);
  EXPECT_EQ(ulpBin(std::uint64_t{1} << 32U), kUlpBinCount - 1);
  for (std::size_t bin = 0; bin < kUlpBinCount; ++bin) {
    EXPECT_EQ(ulpBin(mostUlpsOf(bin)), bin);
    EXPECT_EQ(ulpBin(mostUlpsOf(bin) + 1), std::min(bin + 1, kUlpBinCount - 1));
  }
}

TEST(Ledger, ImagesAreCountedTexelByTexel) {
  const Image a = rowImage({1.0F, 1.0F, 1.0F, 1000.0F, kInfinity, kInfinity, kNaN, 0.0F});
  const Image b = rowImage({1.0F, next(1.0F), next(1.0F, 6), 1000.5F, kInfinity, 5.0F, 1.0F, -0.0F});
  const LedgerEntry entry = compareForLedger(a, b, kSingle);
  EXPECT_EQ(entry.compared, 8U);
  EXPECT_EQ(entry.identical, 2U);  // 1 and the two infinities
  EXPECT_EQ(entry.flips, 2U);      // coverage, and a NaN
  EXPECT_EQ(entry.ulps[0], 3U);    // the identical ones, and the zeros
  EXPECT_EQ(entry.ulps[1], 1U);
  EXPECT_EQ(entry.ulps[ulpBin(6)], 1U);
  EXPECT_EQ(entry.max_ulps, 8192U);  // half of 1 at 1000, where the ulp is 2^-14
  EXPECT_DOUBLE_EQ(entry.max_relative, 0.5 / 1000.5);
  EXPECT_EQ(entry.percentile(0.5), 0U);
  EXPECT_EQ(entry.percentile(0.6), 1U);
  EXPECT_EQ(entry.percentile(0.8), 8U);  // 6, rounded up to its bin
  EXPECT_EQ(entry.percentile(1.0), 8192U);
}

TEST(Ledger, WhatIsNoNumberAgreesOrFlips) {
  const float other_nan = std::bit_cast<float>(std::bit_cast<std::uint32_t>(kNaN) | 1U);
  const LedgerEntry entry =
      compareForLedger(rowImage({kNaN, kNaN, kNaN, kInfinity, kInfinity}),
                       rowImage({kNaN, other_nan, kInfinity, -kInfinity, kNaN}), kSingle);
  EXPECT_EQ(entry.identical, 1U);
  EXPECT_EQ(entry.ulps[0], 2U);  // two NaN agree, whatever their payload
  EXPECT_EQ(entry.flips, 3U);
  EXPECT_EQ(entry.max_relative, 0.0);
}

TEST(Ledger, ATexelIsAsFarAsItsWorstChannel) {
  Image a({1, 1}, {"R", "G", "B"});
  a.data = {1.0F, 1.0F, 1.0F};
  Image b = a;
  b.data = {1.0F, next(1.0F, 3), next(1.0F)};
  const LedgerEntry entry = compareForLedger(a, b, kSingle);
  EXPECT_EQ(entry.compared, 1U);
  EXPECT_EQ(entry.identical, 0U);
  EXPECT_EQ(entry.max_ulps, 3U);
}

TEST(Ledger, RecordsCountRaysAndFlipByClassAndTexel) {
  RayRecord a{{6, 1},
              {without(RayClass::kMasked), hitAt(1, 1), hitAt(1, 1), hitAt(1, 1), hitAt(1, 1, 10),
               without(RayClass::kRange)}};
  RayRecord b = a;
  b.rays[1].t_m = next(b.rays[1].t_m, 2);
  b.rays[2] = hitAt(1, 2);
  b.rays[3] = without(RayClass::kOffscreen);
  b.rays[4].lookups = 11;
  const LedgerEntry entry = compareForLedger(a, b);
  EXPECT_EQ(entry.compared, 5U);   // the masked pixel has no ray
  EXPECT_EQ(entry.identical, 1U);  // the ray out of range
  EXPECT_EQ(entry.flips, 2U);
  EXPECT_EQ(entry.ulps[0], 2U);
  EXPECT_EQ(entry.ulps[2], 1U);
  EXPECT_EQ(entry.max_ulps, 2U);
}

TEST(Ledger, EveryPairOfDevicesHasItsEntries) {
  Bench bench;
  for (const char* const device : {"a", "b", "c"}) {
    Answer& answer = bench.add("hiz", shiftedRecord({4, 2}), device);
    bench.setImage(answer, "composite", device[0] == 'c' ? next(1.0F) : 1.0F);
  }
  bench.add("dda", shiftedRecord({4, 2}), "a");  // nobody else answered it
  Ledger ledger;
  addToLedger(bench.answers, {}, ledger);
  EXPECT_EQ(ledger.size(), 6U);  // three pairs, two buffers
  const LedgerEntry& same = ledger.at({"a", "b", "", "hiz", "composite"});
  EXPECT_EQ(same.identical, 8U);
  const LedgerEntry& differs = ledger.at({"b", "c", "", "hiz", "composite"});
  EXPECT_EQ(differs.identical, 0U);
  EXPECT_EQ(differs.max_ulps, 1U);
  EXPECT_EQ(ledger.at({"a", "c", "", "hiz", "hit"}).identical, 8U);
}

TEST(Ledger, ImagesOfTheFrameAreCountedOnceAndHalvesAsHalves) {
  Bench bench;
  for (const char* const device : {"a", "b"}) {
    Answer& frame = bench.add("", {{4, 2}, {}}, device);
    frame.record = nullptr;
    const Image* const lit = &bench.setImage(frame, "lit", device[0] == 'b' ? 1.0F + 0x1p-10F : 1.0F);
    Answer& trace = bench.add("hiz", shiftedRecord({4, 2}), device);
    trace.images["lit"] = lit;
  }
  Ledger ledger;
  addToLedger(bench.answers, {"lit"}, ledger);
  EXPECT_EQ(ledger.size(), 2U);
  const LedgerEntry& lit = ledger.at({"a", "b", "", "", "lit"});
  EXPECT_EQ(lit.compared, 8U);
  EXPECT_EQ(lit.max_ulps, 1U);
}

TEST(Ledger, EntriesAddUp) {
  LedgerEntry sum = compareForLedger(rowImage({1.0F, kNaN}), rowImage({next(1.0F), 2.0F}), kSingle);
  sum += compareForLedger(rowImage({4.0F}), rowImage({5.0F}), kSingle);
  EXPECT_EQ(sum.compared, 3U);
  EXPECT_EQ(sum.flips, 1U);
  EXPECT_EQ(sum.max_relative, 0.2);
  EXPECT_EQ(sum, compareForLedger(rowImage({1.0F, kNaN, 4.0F}), rowImage({next(1.0F), 2.0F, 5.0F}), kSingle));
}

}  // namespace
}  // namespace ssrkit
