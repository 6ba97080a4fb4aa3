#include "check/judge_claim.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace ssrkit {

namespace {

bool isMeasured(const CheckResult& check) {
  using enum Outcome;
  const bool was_made = check.outcome == kPass || check.outcome == kFail || check.outcome == kInconclusive;
  return was_made && (check.compared > 0 || check.outcome == kPass);
}

ClaimVerdict verdictOf(const CheckResult& check, const RefutingBounds& refuting) {
  if (!isMeasured(check)) {
    return ClaimVerdict::kNotMeasured;
  }
  if (check.outcome == Outcome::kPass) {
    return ClaimVerdict::kConfirmed;
  }
  if (!check.value) {
    return ClaimVerdict::kInconclusive;
  }
  const auto [low, high] = check.interval.value_or(std::pair{*check.value, *check.value});
  const bool refutes =
      (refuting.above && low >= *refuting.above) || (refuting.below && high <= *refuting.below);
  return refutes ? ClaimVerdict::kRefuted : ClaimVerdict::kInconclusive;
}

// The expectation that a check's id names, after the test's own and a dot.
std::optional<std::size_t> expectationOf(const Claim& claim, const CheckResult& check) {
  for (std::size_t i = 0; i < claim.test.expectations.size(); ++i) {
    if (check.id == claim.test.id + "." + claim.test.expectations[i].name) {
      return i;
    }
  }
  return std::nullopt;
}

ClaimVerdict wholeVerdict(const std::vector<ClaimFigure>& figures) {
  const auto any = [&](ClaimVerdict verdict) {
    return std::ranges::any_of(
        figures, [&](const ClaimFigure& figure) { return figure.decides && figure.verdict == verdict; });
  };
  for (const ClaimVerdict verdict : {ClaimVerdict::kNotMeasured, ClaimVerdict::kRefuted,
                                     ClaimVerdict::kInconclusive, ClaimVerdict::kConfirmed}) {
    if (any(verdict)) {
      return verdict;
    }
  }
  return ClaimVerdict::kNotMeasured;
}

}  // namespace

ClaimResult judgeClaim(const Claim& claim, std::span<const CheckResult> checks) {
  ClaimResult result;
  for (const CheckResult& check : checks) {
    ClaimFigure& figure = result.figures.emplace_back();
    figure.check = check;
    const auto expectation = expectationOf(claim, check);
    if (expectation) {
      figure.refuting = claim.refuting[*expectation];
      figure.verdict = verdictOf(check, figure.refuting);
      // A figure that could not be had decides even where it was to be shown only; one of nothing
      // (allow_empty) does not.
      const bool is_unknown = figure.verdict == ClaimVerdict::kNotMeasured;
      figure.decides = is_unknown || (claim.decides(*expectation) && check.compared > 0);
    }
  }
  result.verdict = wholeVerdict(result.figures);
  return result;
}

}  // namespace ssrkit
