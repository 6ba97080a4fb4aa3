// The fault of SSRKIT_FAULT (supervisor.h): a hook for tests that need a driver to fail.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace ssrkit {

class Fault {
 public:
  // No fault when the variable is not set; fails on one of another form than "crash:TEXT", "hang:TEXT",
  // "spin:TEXT".
  [[nodiscard]] static Expected<Fault> fromEnvironment();

  // Does not return when `place` contains TEXT.
  void strikeAt(std::string_view place) const;

 private:
  std::string kind_;
  std::string text_;
};

}  // namespace ssrkit
