#include "worker/fault.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>

#include "base/text.h"

namespace ssrkit {

namespace {

// "barrier" is the Vulkan devices' own: their barriers wait for nothing.
constexpr std::array<std::string_view, 5> kKinds{"crash", "hang", "spin", "wrong", "barrier"};
constexpr std::string_view kAfter = "after=";
constexpr std::string_view kOnce = "once=";

// False when another process was there before.
bool makeFile(const std::string& file) {
  const int fd = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
  if (fd >= 0) {
    ::close(fd);
  }
  return fd >= 0;
}

}  // namespace

Expected<Fault> Fault::fromEnvironment() {
  Fault fault;
  const char* const value = std::getenv("SSRKIT_FAULT");
  if (value == nullptr) {
    return fault;
  }
  const std::string setting = value;
  std::vector<std::string> parts = split(setting, ';');
  const std::size_t colon = parts.empty() ? std::string::npos : parts.front().find(':');
  bool is_known = colon != std::string::npos;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const bool is_after = parts[i].starts_with(kAfter);
    is_known = is_known && (is_after || parts[i].starts_with(kOnce));
    (is_after ? fault.after_ : fault.once_) =
        parts[i].substr(std::min(parts[i].size(), parts[i].find('=') + 1));
  }
  if (is_known) {
    fault.kind_ = parts.front().substr(0, colon);
    fault.text_ = parts.front().substr(colon + 1);
  }
  if (!is_known || std::ranges::find(kKinds, fault.kind_) == kKinds.end()) {
    return inputError(
        "read SSRKIT_FAULT", fmt::format("'{}' names no fault", setting), {},
        "write crash:TEXT, hang:TEXT, spin:TEXT or wrong:TEXT, then ;after=TEXT or ;once=FILE, or barrier:, "
        "or unset it");
  }
  return fault;
}

bool Fault::isTime(std::string_view place) {
  const bool has_passed = after_.empty() || has_passed_;
  has_passed_ = has_passed_ || (!after_.empty() && place.find(after_) != std::string_view::npos);
  return !kind_.empty() && has_passed && place.find(text_) != std::string_view::npos &&
         (once_.empty() || makeFile(once_));
}

bool Fault::spoils(std::string_view place) {
  return kind_ == "wrong" && isTime(place);
}

void Fault::strikeAt(std::string_view place) {
  if (kind_ == "wrong" || kind_ == "barrier" || !isTime(place)) {
    return;
  }
  if (kind_ == "crash") {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
  }
  while (kind_ == "hang") {
    ::pause();
  }
  volatile bool spinning = true;
  while (spinning) {
  }
}

}  // namespace ssrkit
