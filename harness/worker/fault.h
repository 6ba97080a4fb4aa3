// The fault of SSRKIT_FAULT (docs/architecture.md, "Why workers"): a hook for tests that need a driver to
// fail.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace ssrkit {

class Fault {
 public:
  // No fault when the variable is not set; fails on one of another form than
  // KIND:TEXT[;after=OTHER][;once=FILE], where KIND is crash, hang, spin, wrong or barrier.
  [[nodiscard]] static Expected<Fault> fromEnvironment();

  // Of the kinds crash, hang and spin: does not return when `place` contains TEXT. The others do nothing
  // here: `wrong` asks spoils(), `barrier` is the Vulkan devices' own.
  void strikeAt(std::string_view place);

  // Whether the answer that was made at `place` is to be spoilt: the kind `wrong` alone.
  [[nodiscard]] bool spoils(std::string_view place);

 private:
  [[nodiscard]] bool isTime(std::string_view place);

  std::string kind_;
  std::string text_;
  std::string after_;        // strikes only after a place with this text
  std::string once_;         // strikes only where this file is not there yet, and makes it
  bool has_passed_ = false;  // such a place
};

}  // namespace ssrkit
