// The ledger: how far apart the answers of two devices lie, buffer by buffer, as a few numbers that add up
// over cells.
//
// A texel is compared channel by channel, and its worst channel counts:
// - the same bits in all channels: identical, and 0 ulp;
// - two NaN of any payload agree, and so do +0 and -0: 0 ulp, though not identical;
// - finite on one side only, a NaN against an infinity, or infinities of both signs: a flip, without a
// distance;
// - otherwise the distance in ulps: how many numbers of the buffer's format lie between the two, across zero
// too. Of a ray record, a flip is a ray of another outcome class or hit texel; the distance is that of the
// hit position and of t_m, over rays that hit the same texel; lookups and steps count for `identical` only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "check/subject.h"
#include "image/image.h"
#include "image/ray_record.h"

namespace ssrkit {

// A buffer of two devices. With `input`, both were given the G-buffer of that device.
struct LedgerKey {
  std::string device;  // before `other` in the order of answers
  std::string other;
  std::string input;
  std::string stage;   // empty: of the frame
  std::string buffer;  // "hit" for the ray record
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads what is generated
  auto operator<=>(const LedgerKey&) const = default;
};

// 0, 1, 2, 3 and 4 ulp, then up to 8, up to 16, ... up to 2^32.
inline constexpr std::size_t kUlpBinCount = 35;
[[nodiscard]] std::size_t ulpBin(std::uint64_t ulps);
[[nodiscard]] std::uint64_t mostUlpsOf(std::size_t bin);

struct LedgerEntry {
  std::size_t compared = 0;   // texels, or pixels that have a ray on either side
  std::size_t identical = 0;  // in every bit
  std::size_t flips = 0;
  std::array<std::size_t, kUlpBinCount> ulps{};  // texels that are no flips, by their worst channel
  std::uint64_t max_ulps = 0;
  double max_relative = 0.0;  // |a - b| / max(|a|, |b|), of texels that are no flips

  bool operator==(const LedgerEntry&) const = default;
  LedgerEntry& operator+=(const LedgerEntry& more);

  // The distance that `share` (0..1) of the texels that are no flips do not exceed, rounded up to its bin; 0
  // of none.
  [[nodiscard]] std::uint64_t percentile(double share) const;
};

using Ledger = std::map<LedgerKey, LedgerEntry>;

enum class FloatFormat : std::uint8_t { kHalf, kSingle };

// How many numbers of `format` lie from a to b, both finite and (for kHalf) halves.
[[nodiscard]] std::uint64_t ulpsBetween(float a, float b, FloatFormat format);

// Two images of one size and the same channels (checked).
[[nodiscard]] LedgerEntry compareForLedger(const Image& a, const Image& b, FloatFormat format);
[[nodiscard]] LedgerEntry compareForLedger(const RayRecord& a, const RayRecord& b);

// Adds every pair of answers that differ in nothing but their device. Images of unequal size or channels are
// left out: a check says so. `half_buffers` are stored as halves on the devices.
void addToLedger(std::span<const Answer> answers, const std::set<std::string>& half_buffers, Ledger& ledger);

void addToLedger(const Ledger& more, Ledger& ledger);

}  // namespace ssrkit
