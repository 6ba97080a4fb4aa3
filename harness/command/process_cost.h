// What a whole run of the program costs, its workers included.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct ProcessCost {
  double wall_s = 0.0;
  double peak_memory_mib = 0.0;  // of all its processes together; shared pages count once (Pss)
  int exit_code = 0;             // as runChild tells it
};

// The processors that this process may run on.
[[nodiscard]] int usableCoreCount();

// Runs this program with these arguments, its output thrown away, and waits for it. Memory is looked at 50
// times a second, which takes time of its own: 0 unless it is wanted. `core_count`: it and its workers keep
// to the first so many of the usable processors; 0: to all of them.
[[nodiscard]] Expected<ProcessCost> measureProcess(const std::vector<std::string>& arguments,
                                                   bool wants_memory, int core_count = 0);

}  // namespace ssrkit
