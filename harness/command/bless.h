// `ssrkit bless`: writes goldens, the only thing that does.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct BlessOptions {
  std::string test;                  // the id of an expectation file with truth = "golden"
  std::vector<std::string> scenes;   // of the test's; empty: all of them
  std::vector<std::string> devices;  // empty: the test's first, or gl-osmesa; its goldens may serve its kin
  std::string why;
  std::string who;    // empty: git's identity
  bool json = false;  // on standard output instead of text
};

// Runs the test, shows what changes, and writes the goldens. Refused without a reason or a name, in CI, over
// shaders or scenes that are not committed, and when a check of the test against any other truth fails.
[[nodiscard]] Expected<int> blessCommand(const BlessOptions& options);

}  // namespace ssrkit
