#include "check/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace ssrkit {

namespace {

constexpr std::array<const char*, kOutcomeCount> kOutcomeNames = {
    "pass",    "warn",  "fail",    "error", "skip",  "crash",       "timeout",
    "limiter", "flake", "missing", "xfail", "xpass", "inconclusive"};

std::size_t count(std::span<const Outcome> outcomes, Outcome wanted) {
  return static_cast<std::size_t>(std::ranges::count(outcomes, wanted));
}

}  // namespace

const char* name(Outcome outcome) {
  return kOutcomeNames.at(static_cast<std::size_t>(outcome));
}

std::optional<Outcome> outcomeFromName(std::string_view outcome_name) {
  const auto found = std::ranges::find(kOutcomeNames, outcome_name);
  if (found == kOutcomeNames.end()) {
    return std::nullopt;
  }
  return static_cast<Outcome>(found - kOutcomeNames.begin());
}

bool isFailure(Outcome outcome) {
  switch (outcome) {
    case Outcome::kFail:
    case Outcome::kError:
    case Outcome::kCrash:
    case Outcome::kTimeout:
    case Outcome::kLimiter:
    case Outcome::kMissing:
    case Outcome::kXpass:
      return true;
    case Outcome::kPass:
    case Outcome::kWarn:
    case Outcome::kSkip:
    case Outcome::kFlake:
    case Outcome::kXfail:
    case Outcome::kInconclusive:
      return false;
  }
  return true;
}

int exitCode(std::span<const Outcome> outcomes) {
  const bool none_executed = count(outcomes, Outcome::kSkip) == outcomes.size();
  if (none_executed || std::ranges::any_of(outcomes, isFailure)) {
    return kExitCheckFailed;
  }
  const bool unsure = count(outcomes, Outcome::kFlake) + count(outcomes, Outcome::kInconclusive) > 0;
  return unsure ? kExitUnsure : kExitWell;
}

std::string closingLine(std::span<const Outcome> outcomes) {
  const std::size_t passed =
      count(outcomes, Outcome::kPass) + count(outcomes, Outcome::kWarn) + count(outcomes, Outcome::kXfail);
  const std::string line =
      fmt::format("{} passed, {} failed", passed, std::ranges::count_if(outcomes, isFailure));
  const std::size_t skipped = count(outcomes, Outcome::kSkip);
  return skipped > 0 ? fmt::format("{}, {} skipped", line, skipped) : line;
}

}  // namespace ssrkit
