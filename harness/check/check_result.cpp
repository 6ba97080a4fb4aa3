#include "check/check_result.h"

#include <fmt/format.h>

namespace ssrkit {

std::string boundText(const CheckResult& result) {
  std::string text;
  if (result.min && result.max) {
    text = fmt::format("{:g} .. {:g}", *result.min, *result.max);
  } else if (result.max) {
    text = fmt::format("<= {:g}", *result.max);
  } else if (result.min) {
    text = fmt::format(">= {:g}", *result.min);
  } else {
    return {};
  }
  return result.unit.empty() ? text : text + " " + result.unit;
}

std::string fullName(const CheckResult& result) {
  std::string text =
      fmt::format("{} {} {}x{}", result.id, result.scene, result.size.width, result.size.height);
  for (const std::string* part : {&result.case_name, &result.device, &result.stage}) {
    if (!part->empty()) {
      text += " " + *part;
    }
  }
  return text;
}

}  // namespace ssrkit
