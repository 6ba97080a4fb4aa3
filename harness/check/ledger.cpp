#include "check/ledger.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/share_out.h"
#include "check/ray_bits.h"

namespace ssrkit {

namespace {

// The number's place among all numbers of the format in their order; both zeros are 0.
std::int64_t orderOf(float value, FloatFormat format) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  std::int64_t magnitude = bits & 0x7FFFFFFFU;
  if (format == FloatFormat::kHalf) {
    // A half's place is that of its float, but for subnormal halves, which are equally spaced by 2^-24.
    constexpr float kLeastNormal = 6.103515625e-5F;  // 2^-14
    constexpr std::int64_t kFloatsPerHalf = 1 << 13;
    constexpr std::int64_t kPlaceOfLeastNormal = 1024;
    constexpr auto kBitsOfLeastNormal = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(kLeastNormal));
    const float size = std::abs(value);
    magnitude = size < kLeastNormal ? std::llround(static_cast<double>(size) * (1 << 24))
                                    : kPlaceOfLeastNormal + (magnitude - kBitsOfLeastNormal) / kFloatsPerHalf;
  }
  return std::signbit(value) ? -magnitude : magnitude;
}

// What is known of one texel, channel after channel.
struct TexelComparison {
  bool is_identical = true;
  bool is_flip = false;
  std::uint64_t ulps = 0;
  double relative = 0.0;

  void add(float a, float b, FloatFormat format) {
    is_identical = is_identical && sameBits(a, b);
    if (a == b || (std::isnan(a) && std::isnan(b))) {
      return;
    }
    if (!std::isfinite(a) || !std::isfinite(b)) {
      is_flip = true;
      return;
    }
    ulps = std::max(ulps, ulpsBetween(a, b, format));
    const double x = a;
    const double y = b;
    relative = std::max(relative, std::abs(x - y) / std::max(std::abs(x), std::abs(y)));
  }
};

void add(const TexelComparison& texel, LedgerEntry& entry) {
  ++entry.compared;
  entry.identical += texel.is_identical ? 1 : 0;
  if (texel.is_flip) {
    ++entry.flips;
    return;
  }
  ++entry.ulps.at(ulpBin(texel.ulps));
  entry.max_ulps = std::max(entry.max_ulps, texel.ulps);
  entry.max_relative = std::max(entry.max_relative, texel.relative);
}

TexelComparison compareRays(const RayHit& a, const RayHit& b) {
  TexelComparison ray;
  ray.is_flip = a.ray_class != b.ray_class || a.texel_x != b.texel_x || a.texel_y != b.texel_y;
  for (const auto& [x, y] : {std::pair(a.px_x, b.px_x), std::pair(a.px_y, b.px_y), std::pair(a.t_m, b.t_m)}) {
    ray.add(x, y, FloatFormat::kSingle);
  }
  ray.is_identical = ray.is_identical && !ray.is_flip && a.lookups == b.lookups && a.steps == b.steps;
  return ray;
}

bool areTwins(const Answer& a, const Answer& b) {
  return a.device != b.device && a.stage == b.stage && a.case_name == b.case_name && a.size == b.size &&
         a.input == b.input && a.variant == b.variant;
}

// Answers of a trace also hold the frame's images: those are compared once, with the frame's own answer.
bool isFrames(const std::string& buffer, const Answer& answer, std::span<const Answer> answers) {
  return !answer.stage.empty() && std::ranges::any_of(answers, [&](const Answer& frame) {
    const auto image = frame.images.find(buffer);
    return frame.stage.empty() && frame.device == answer.device && frame.size == answer.size &&
           frame.input == answer.input && image != frame.images.end() &&
           image->second == answer.images.at(buffer);
  });
}

}  // namespace

std::size_t ulpBin(std::uint64_t ulps) {
  constexpr std::uint64_t kSingles = 4;
  return ulps <= kSingles ? ulps : std::min<std::size_t>(2 + std::bit_width(ulps - 1), kUlpBinCount - 1);
}

std::uint64_t mostUlpsOf(std::size_t bin) {
  constexpr std::size_t kSingles = 4;
  return bin <= kSingles ? bin : std::uint64_t{1} << (bin - 2);
}

LedgerEntry& LedgerEntry::operator+=(const LedgerEntry& more) {
  compared += more.compared;
  identical += more.identical;
  flips += more.flips;
  std::ranges::transform(ulps, more.ulps, ulps.begin(), std::plus{});
  max_ulps = std::max(max_ulps, more.max_ulps);
  max_relative = std::max(max_relative, more.max_relative);
  return *this;
}

std::uint64_t LedgerEntry::percentile(double share) const {
  const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(compared - flips)));
  std::size_t below = 0;
  for (std::size_t bin = 0; bin < ulps.size(); ++bin) {
    below += ulps[bin];
    if (below >= wanted) {
      return std::min(mostUlpsOf(bin), max_ulps);
    }
  }
  return max_ulps;
}

std::uint64_t ulpsBetween(float a, float b, FloatFormat format) {
  return static_cast<std::uint64_t>(std::abs(orderOf(a, format) - orderOf(b, format)));
}

LedgerEntry compareForLedger(const Image& a, const Image& b, FloatFormat format) {
  SSRKIT_CHECK(a.size == b.size && a.channels == b.channels);
  LedgerEntry entry;
  const std::size_t channel_count = a.channelCount();
  for (std::size_t first = 0; first < a.data.size(); first += channel_count) {
    TexelComparison texel;
    for (std::size_t i = first; i < first + channel_count; ++i) {
      texel.add(a.data[i], b.data[i], format);
    }
    add(texel, entry);
  }
  return entry;
}

LedgerEntry compareForLedger(const RayRecord& a, const RayRecord& b) {
  SSRKIT_CHECK(a.size == b.size);
  LedgerEntry entry;
  for (std::size_t i = 0; i < a.rays.size(); ++i) {
    if (!hasNoRay(a.rays[i].ray_class) || !hasNoRay(b.rays[i].ray_class)) {
      add(compareRays(a.rays[i], b.rays[i]), entry);
    }
  }
  return entry;
}

void addToLedger(std::span<const Answer> answers, const std::set<std::string>& half_buffers, Ledger& ledger) {
  std::vector<std::pair<LedgerKey, std::function<LedgerEntry()>>> comparisons;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (std::size_t j = i + 1; j < answers.size(); ++j) {
      const Answer& a = answers[i];
      const Answer& b = answers[j];
      if (!areTwins(a, b)) {
        continue;
      }
      LedgerKey key{
          .device = a.device, .other = b.device, .input = a.input, .stage = a.stage, .buffer = "hit"};
      if (a.record != nullptr && b.record != nullptr && a.record->size == b.record->size) {
        comparisons.emplace_back(key, [&a, &b] { return compareForLedger(*a.record, *b.record); });
      }
      for (const auto& [buffer, image] : a.images) {
        const auto twin = b.images.find(buffer);
        const bool is_pair = twin != b.images.end() && twin->second->size == image->size &&
                             twin->second->channels == image->channels;
        if (is_pair && !isFrames(buffer, a, answers)) {
          key.buffer = buffer;
          const FloatFormat format =
              half_buffers.contains(buffer) ? FloatFormat::kHalf : FloatFormat::kSingle;
          comparisons.emplace_back(key, [image = image, other = twin->second, format] {
            return compareForLedger(*image, *other, format);
          });
        }
      }
    }
  }
  std::vector<LedgerEntry> entries(comparisons.size());
  forEachInParallel(static_cast<int>(comparisons.size()), 0, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    entries[place] = comparisons[place].second();
  });
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    ledger[comparisons[i].first] += entries[i];
  }
}

void addToLedger(const Ledger& more, Ledger& ledger) {
  for (const auto& [key, entry] : more) {
    ledger[key] += entry;
  }
}

}  // namespace ssrkit
