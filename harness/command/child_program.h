// Runs another program to its end: the unit tests, the compiler.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct ChildProgram {
  std::vector<std::string> arguments;                            // the program first, looked up in PATH
  std::vector<std::pair<std::string, std::string>> environment;  // over this process's own
  std::filesystem::path folder;                                  // where it runs; empty: here
  std::filesystem::path output;                                  // what it prints
  std::chrono::seconds limit{300};                               // of wall time; then it is killed
};

// Its exit code, or 128 and the signal that ended it: 137 when the limit did. An Error when it cannot be
// started.
[[nodiscard]] Expected<int> runChild(const ChildProgram& program);

}  // namespace ssrkit
