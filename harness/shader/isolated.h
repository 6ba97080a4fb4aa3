// Runs work that may crash, hang or eat all memory on hostile input, in a child process.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace ssrkit {

struct IsolationLimits {
  int cpu_seconds = 10;
  std::size_t memory_bytes = std::size_t{2} << 30;  // beyond what the process has at the start
};

enum class IsolationEnd {
  kDone,
  kCrashed,  // a signal, or an end without a result
  kOverTime,
  kOutOfMemory,
  kNotStarted,  // the system refused a process
};

struct IsolatedResult {
  IsolationEnd end = IsolationEnd::kNotStarted;
  std::string bytes;    // what `work` returned, when done
  std::string details;  // the signal or errno in words, when not
};

// Forks, calls `work` in the child and hands its result back. The child shares no memory with the caller:
// `work` must not take locks that other threads of the caller may hold, nor touch a graphics driver.
[[nodiscard]] IsolatedResult runIsolated(const std::function<std::string()>& work,
                                         const IsolationLimits& limits = {});

}  // namespace ssrkit
