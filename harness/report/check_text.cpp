#include "report/check_text.h"

#include <fmt/format.h>

namespace ssrkit {

std::string summaryLine(const CheckResult& check) {
  const bool has_reason = check.outcome == Outcome::kSkip || check.outcome == Outcome::kXfail ||
                          check.outcome == Outcome::kXpass || check.outcome == Outcome::kFlake;
  if (check.value && !has_reason) {
    const std::string bound = boundText(check);
    return fmt::format("{} = {:.6g} {}{}{}", check.metric, *check.value, check.unit,
                       bound.empty() ? "" : ", expected ", bound);
  }
  const std::string line = check.message.substr(0, check.message.find('\n'));
  return line.empty() ? name(check.outcome) : line;
}

}  // namespace ssrkit
