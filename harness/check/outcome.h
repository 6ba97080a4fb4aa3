// What can become of one check, and what a whole run of them tells the shell.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ssrkit {

enum class Outcome : std::uint8_t {
  kPass,
  kWarn,          // holds, but poorly: shown, never gates
  kFail,          // the answer is wrong
  kError,         // the check itself could not be made: no truth to compare with, sizes that do not agree
  kSkip,          // not asked of this device, with the reason in the message
  kCrash,         // the worker died
  kTimeout,       // the worker was stopped
  kLimiter,       // the driver cut a loop short
  kFlake,         // failed, then passed when it was run again
  kMissing,       // planned, but never reported
  kXfail,         // failed, and was known to fail
  kXpass,         // passed, but was known to fail: the list of known failures is stale
  kInconclusive,  // the measurement's noise is larger than the margin
};
inline constexpr int kOutcomeCount = 13;

[[nodiscard]] const char* name(Outcome outcome);  // "xfail"
[[nodiscard]] std::optional<Outcome> outcomeFromName(std::string_view outcome_name);

// Fails the run: fail, error, crash, timeout, limiter, missing, xpass.
[[nodiscard]] bool isFailure(Outcome outcome);

// Exit code of a whole process. 2 and 3 come from `exitCode(const Error&)`.
inline constexpr int kExitWell = 0;
inline constexpr int kExitCheckFailed = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitBrokenSetup = 3;
inline constexpr int kExitUnsure = 4;  // nothing failed, but something was a flake or inconclusive

// Exit code of a run by its checks: 0, 1 or 4. A run in which no check was executed (none at all, or only
// skips) has failed.
[[nodiscard]] int exitCode(std::span<const Outcome> outcomes);

// The last line of a run, which programs read: "12 passed, 0 failed", then ", 1 skipped" where there are any.
// warn and xfail count as passed; flake and inconclusive are neither, and told elsewhere.
[[nodiscard]] std::string closingLine(std::span<const Outcome> outcomes);

}  // namespace ssrkit
