#include "check/claim.h"

#include <array>

#include "base/check.h"

namespace ssrkit {

namespace {

constexpr std::array<const char*, 4> kClaimVerdictNames = {"confirmed", "inconclusive", "refuted",
                                                           "not measured"};

}  // namespace

const char* name(ClaimVerdict verdict) {
  return kClaimVerdictNames.at(static_cast<std::size_t>(verdict));
}

std::optional<ClaimVerdict> claimVerdictFromName(std::string_view verdict_name) {
  for (std::size_t i = 0; i < kClaimVerdictNames.size(); ++i) {
    if (verdict_name == kClaimVerdictNames.at(i)) {
      return static_cast<ClaimVerdict>(i);
    }
  }
  return std::nullopt;
}

bool Claim::decides(std::size_t expectation) const {
  const Expectation& asked = test.expectations.at(expectation);
  return asked.max || asked.min;
}

}  // namespace ssrkit
