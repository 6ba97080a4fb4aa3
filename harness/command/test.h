// `ssrkit test`: the unit and end-to-end tests, then every expectation file of tests/expect on its devices.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct TestOptions {
  std::string filter = "*";       // of names: * stands for any text
  std::string only;               // "unit" or "expect"; "" both
  std::vector<std::string> tags;  // of expectation files, one of which they carry; empty: any, and unit tests
  std::vector<std::string> devices{"gl-osmesa", "vk-lavapipe"};
  std::filesystem::path out = "out/test";  // results.json
  bool list = false;                       // names instead of runs
  bool json = false;                       // results.json on standard output instead of text
  std::vector<std::string> command;        // argv, for the report
};

// The exit code of design section 6, after printing "N passed, N failed" as the last line.
[[nodiscard]] Expected<int> testCommand(const TestOptions& options);

}  // namespace ssrkit
