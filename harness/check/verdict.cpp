#include "check/verdict.h"

#include <algorithm>
#include <cstdlib>

#include "base/check.h"
#include "check/leak.h"

namespace ssrkit {

namespace {

constexpr std::array<const char*, kVerdictCount> kVerdictNames = {
    "NONE", "SAME", "NEAR", "WRONG", "FALSE_HIT", "MISSED_HIT", "LEAK", "AMBIGUOUS"};

// Everything that can be said without the ray's path.
Verdict compareAnswers(const RayHit& yours, const RayHit& oracle, Ambiguity ambiguity) {
  if (yours.ray_class == oracle.ray_class && hasNoRay(yours.ray_class)) {
    return Verdict::kNone;
  }
  const bool same_texel = yours.texel_x == oracle.texel_x && yours.texel_y == oracle.texel_y;
  if (yours.ray_class == oracle.ray_class && same_texel) {
    return Verdict::kSame;
  }
  if (ambiguity != Ambiguity::kNone) {
    return Verdict::kAmbiguous;
  }
  const bool yours_hit = yours.ray_class == RayClass::kHit;
  const bool oracle_hit = oracle.ray_class == RayClass::kHit;
  if (yours_hit && oracle_hit) {
    const bool near =
        std::abs(yours.texel_x - oracle.texel_x) <= 1 && std::abs(yours.texel_y - oracle.texel_y) <= 1;
    return near ? Verdict::kNear : Verdict::kWrong;
  }
  if (yours_hit) {
    return Verdict::kFalseHit;
  }
  return oracle_hit ? Verdict::kMissedHit : Verdict::kWrong;
}

}  // namespace

const char* name(Verdict verdict) {
  return kVerdictNames.at(static_cast<std::size_t>(verdict));
}

std::optional<Verdict> verdictFromName(std::string_view verdict_name) {
  const auto found = std::ranges::find(kVerdictNames, verdict_name);
  if (found == kVerdictNames.end()) {
    return std::nullopt;
  }
  return static_cast<Verdict>(found - kVerdictNames.begin());
}

std::vector<Verdict> compareWithOracle(const RayRecord& record, const OracleResult& oracle,
                                       const OracleInput& input) {
  SSRKIT_CHECK(record.size == oracle.record.size && record.size == input.dist_view->size);
  SSRKIT_CHECK_EQ(record.rays.size(), oracle.record.rays.size());
  SSRKIT_CHECK_EQ(record.rays.size(), oracle.ambiguity.size());
  std::vector<Verdict> verdicts(record.rays.size());
  LeakClassifier leaks(input);
  std::size_t index = 0;
  for (int y = 0; y < record.size.height; ++y) {
    for (int x = 0; x < record.size.width; ++x, ++index) {
      const RayHit& truth = oracle.record.rays[index];
      Verdict& verdict = verdicts[index];
      verdict = compareAnswers(record.rays[index], truth, oracle.ambiguity[index]);
      const bool lost_hit =
          truth.ray_class == RayClass::kHit && (verdict == Verdict::kWrong || verdict == Verdict::kMissedHit);
      if (lost_hit && leaks.isLeak(record.rays[index], x, y)) {
        verdict = Verdict::kLeak;
      }
    }
  }
  return verdicts;
}

VerdictCounts countVerdicts(std::span<const Verdict> verdicts) {
  VerdictCounts counts{};
  for (const Verdict verdict : verdicts) {
    ++counts.at(static_cast<std::size_t>(verdict));
  }
  return counts;
}

}  // namespace ssrkit
