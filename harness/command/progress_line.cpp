#include "command/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace ssrkit {

namespace {

constexpr std::size_t kMostColumns = 79;  // a longer line would wrap and could not be cleared

}  // namespace

ProgressLine::ProgressLine() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::show(const std::string& text) {
  if (is_terminal_) {
    fmt::print(stderr, "\r\033[K{}", text.substr(0, kMostColumns));
    std::fflush(stderr);
    is_shown_ = true;
  }
}

void ProgressLine::clear() {
  if (is_shown_) {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    is_shown_ = false;
  }
}

}  // namespace ssrkit
