#include "check/baseline.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "base/size.h"

namespace ssrkit {

namespace {

bool fits(const std::string& pattern, const std::string& text) {
  return fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
}

bool fits(const KnownFailure& known, const CheckResult& check, const DeviceTexts& devices) {
  const auto identity = devices.find(check.device);
  const bool driver_fits = known.driver.empty() || (identity != devices.end() &&
                                                    identity->second.find(known.driver) != std::string::npos);
  return driver_fits && fits(known.id, check.id) && fits(known.device, check.device) &&
         fits(known.scene, check.scene) && fits(known.stage, check.stage) &&
         fits(known.case_name, check.case_name) && fits(known.size, sizeText(check.size));
}

std::string reasonText(const KnownFailure& known) {
  return fmt::format("{} ({}, until {})", known.reason, known.bug, dateText(known.expires));
}

// The check as it counts, now that its failure is known.
void judgeAgain(const KnownFailure& known, CheckResult& check) {
  const bool is_expected = std::ranges::find(known.outcomes, check.outcome) != known.outcomes.end();
  const bool is_pass = check.outcome == Outcome::kPass || check.outcome == Outcome::kWarn;
  const std::string rest = check.message.empty() ? "" : "\n" + check.message;
  if (is_expected) {
    check.message = fmt::format("expected {}: {}{}", name(check.outcome), reasonText(known), rest);
    check.outcome = Outcome::kXfail;
  } else if (is_pass) {
    check.message = fmt::format("{} passes, but {} says that it fails: {}; take the entry out{}", check.id,
                                known.where, reasonText(known), rest);
    check.outcome = Outcome::kXpass;
  } else if (isFailure(check.outcome)) {
    check.message += fmt::format("\n  known     {} expects {} here, not {}: {}", known.where,
                                 name(known.outcomes.front()), name(check.outcome), reasonText(known));
  }
}

CheckResult expired(const KnownFailure& known, const CheckResult& example) {
  CheckResult check;
  check.id = "baseline.expired";
  check.scene = example.scene;
  check.device = example.device;
  check.stage = example.stage;
  check.size = example.size;
  check.case_name = example.case_name;
  check.metric = "expired";
  check.outcome = Outcome::kError;
  check.message = fmt::format(
      "{}: the expected failure of '{}' on '{}' has expired on {}: {} ({}); mend it, "
      "or find out why it still fails and move the date",
      known.where, known.id, known.device, dateText(known.expires), known.reason, known.bug);
  check.repro = example.repro;
  return check;
}

}  // namespace

std::string dateText(std::chrono::sys_days day) {
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

std::vector<const KnownFailure*> applyBaseline(std::span<const KnownFailure> baseline,
                                               const DeviceTexts& devices, std::chrono::sys_days today,
                                               std::vector<CheckResult>& checks) {
  std::vector<const CheckResult*> first_fit(baseline.size(), nullptr);
  for (CheckResult& check : checks) {
    bool is_judged = false;
    for (std::size_t i = 0; i < baseline.size(); ++i) {
      if (!fits(baseline[i], check, devices)) {
        continue;
      }
      first_fit[i] = first_fit[i] == nullptr ? &check : first_fit[i];
      if (!is_judged && today <= baseline[i].expires) {
        judgeAgain(baseline[i], check);
        is_judged = true;
      }
    }
  }
  std::vector<const KnownFailure*> unused;
  std::vector<CheckResult> stale;
  for (std::size_t i = 0; i < baseline.size(); ++i) {
    if (first_fit[i] == nullptr) {
      unused.push_back(&baseline[i]);
    } else if (today > baseline[i].expires) {
      stale.push_back(expired(baseline[i], *first_fit[i]));
    }
  }
  checks.insert(checks.end(), stale.begin(), stale.end());
  return unused;
}

}  // namespace ssrkit
