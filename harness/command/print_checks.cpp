#include "command/print_checks.h"

#include <fmt/format.h>

namespace ssrkit {

void printCheck(const CheckResult& check) {
  // The messages of evaluate() start with the check's name and end with the command; those of a job that
  // never came back have neither.
  if (check.message.find(fullName(check)) != std::string::npos) {
    fmt::print("{}\n", check.message);
    return;
  }
  fmt::print("{}: {}\n  {}\n", name(check.outcome), fullName(check), check.message);
  if (!check.repro.empty()) {
    fmt::print("  again     {}\n", check.repro);
  }
}

}  // namespace ssrkit
