// Runs another program to its end: the unit tests, the compiler, this program itself.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ssrkit {

inline constexpr std::chrono::seconds kNoLimit{0};

struct ChildProgram {
  std::vector<std::string> arguments;                            // the program first, looked up in PATH
  std::vector<std::pair<std::string, std::string>> environment;  // over this process's own
  std::filesystem::path folder;                                  // where it runs; empty: here
  std::filesystem::path output;     // what it prints, a file; empty: where this process prints
  std::chrono::seconds limit{300};  // of wall time; then it is killed, with all that it has started
  std::string remedy;               // for one that cannot be started; may be empty
};

// Its exit code, or 128 and the signal that ended it: 137 when the limit did. It leads a process group of its
// own, which ends with it, and with this process when a signal ends that. `look` is called with its number
// again and again while it runs. An Error when it cannot be started, and when its end cannot be told.
[[nodiscard]] Expected<int> runChild(const ChildProgram& program,
                                     const std::function<void(pid_t)>& look = nullptr);

}  // namespace ssrkit
