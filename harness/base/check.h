// Checks for mistakes of the programmer. They stay on in release builds, print both sides and abort:
// a worker that aborts is reported as a crash and the run goes on.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace ssrkit {

[[noreturn]] void checkFailed(std::string_view file, int line, std::string_view condition,
                              std::string_view values);

}  // namespace ssrkit

#define SSRKIT_CHECK(condition)                                  \
  do {                                                           \
    if (!(condition)) {                                          \
      ::ssrkit::checkFailed(__FILE__, __LINE__, #condition, ""); \
    }                                                            \
  } while (false)

#define SSRKIT_CHECK_OP(a, op, b)                                                            \
  do {                                                                                       \
    const auto& ssrkit_check_a = (a);                                                        \
    const auto& ssrkit_check_b = (b);                                                        \
    if (!(ssrkit_check_a op ssrkit_check_b)) {                                               \
      ::ssrkit::checkFailed(__FILE__, __LINE__, #a " " #op " " #b,                           \
                            ::fmt::format("{} against {}", ssrkit_check_a, ssrkit_check_b)); \
    }                                                                                        \
  } while (false)

#define SSRKIT_CHECK_EQ(a, b) SSRKIT_CHECK_OP(a, ==, b)
#define SSRKIT_CHECK_LT(a, b) SSRKIT_CHECK_OP(a, <, b)
#define SSRKIT_CHECK_LE(a, b) SSRKIT_CHECK_OP(a, <=, b)
