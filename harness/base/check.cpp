#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace ssrkit {

void checkFailed(std::string_view file, int line, std::string_view condition, std::string_view values) {
  fmt::print(stderr, "{}:{}: internal check failed: {}{}{}\n", file, line, condition,
             values.empty() ? "" : ": ", values);
  std::fflush(stderr);
  std::abort();
}

}  // namespace ssrkit
