// Known failures: which checks fail on which driver, why, and until when (docs/formats.md). A list that only
// shrinks by itself: what passes although it is listed fails the run, and so does an entry that has expired.
#pragma once

#include <chrono>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "check/check_result.h"

namespace ssrkit {

// One [[expected_failure]]. The patterns know *, ? and [...]; all of them must fit.
struct KnownFailure {
  std::string id;  // of CheckResult::id
  std::string device;
  std::string scene = "*";
  std::string stage = "*";
  std::string case_name = "*";
  std::string size = "*";         // of "640x360"
  std::string driver;             // a part of the device's identity, "" any
  std::vector<Outcome> outcomes;  // those that are expected, never empty
  std::string reason;
  std::chrono::sys_days expires;  // the last day on which it is expected
  std::string bug;                // where the bug is described: "docs/driver-bugs.md#loop-cap"
  std::string where;              // "tests/known_failures.toml:12:1"
};

// By device id: API, driver and version as one text, for `driver`.
using DeviceTexts = std::map<std::string, std::string>;

// Judges the checks again by what is known of them: an expected outcome becomes xfail, a pass (or warn)
// xpass, any other outcome stays and its message names the entry. Entries that have expired excuse nothing;
// each that fits a check adds one check with the outcome error that names it. Returns the entries that fit no
// check, in their order.
[[nodiscard]] std::vector<const KnownFailure*> applyBaseline(std::span<const KnownFailure> baseline,
                                                             const DeviceTexts& devices,
                                                             std::chrono::sys_days today,
                                                             std::vector<CheckResult>& checks);

// "2026-01-31"
[[nodiscard]] std::string dateText(std::chrono::sys_days day);

}  // namespace ssrkit
