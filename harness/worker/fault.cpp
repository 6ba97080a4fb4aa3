#include "worker/fault.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace ssrkit {

Expected<Fault> Fault::fromEnvironment() {
  Fault fault;
  const char* const value = std::getenv("SSRKIT_FAULT");
  if (value == nullptr) {
    return fault;
  }
  const std::string_view setting = value;
  const std::size_t colon = setting.find(':');
  fault.kind_ = setting.substr(0, colon);
  const bool known = fault.kind_ == "crash" || fault.kind_ == "hang" || fault.kind_ == "spin";
  if (!known || colon == std::string_view::npos) {
    return inputError("read SSRKIT_FAULT", fmt::format("'{}' names no fault", setting), {},
                      "write crash:TEXT, hang:TEXT or spin:TEXT, or unset it");
  }
  fault.text_ = setting.substr(colon + 1);
  return fault;
}

void Fault::strikeAt(std::string_view place) const {
  if (kind_.empty() || place.find(text_) == std::string_view::npos) {
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
