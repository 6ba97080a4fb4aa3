// A pixel's verdict: one tracer's ray held against Oracle A's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "image/ray_record.h"
#include "oracle/oracle.h"

namespace ssrkit {

enum class Verdict : std::uint8_t {
  kNone,       // both say MASKED or both say BACKGROUND: there is no ray to compare
  kSame,       // same class and same hit texel
  kNear,       // both hit, the texels at most 1 px apart on either axis
  kWrong,      // both hit, further apart; or neither hit and the classes differ
  kFalseHit,   // the tracer hit, the oracle did not
  kMissedHit,  // the oracle hit, the tracer did not
  kLeak,       // walked through a diagonal line, see leak.h
  kAmbiguous,  // not the same, and the oracle calls the ray a tie in single precision
};
inline constexpr int kVerdictCount = 8;

[[nodiscard]] const char* name(Verdict verdict);  // "FALSE_HIT"
[[nodiscard]] std::optional<Verdict> verdictFromName(std::string_view verdict_name);

// One verdict a pixel. The record, the oracle's answer and the input have the same size (checked).
[[nodiscard]] std::vector<Verdict> compareWithOracle(const RayRecord& record, const OracleResult& oracle,
                                                     const OracleInput& input);

// How often each verdict was given, by its number.
using VerdictCounts = std::array<std::size_t, kVerdictCount>;
[[nodiscard]] VerdictCounts countVerdicts(std::span<const Verdict> verdicts);

}  // namespace ssrkit
