// What a whole run of the program costs, its workers included.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct ProcessCost {
  double wall_s = 0.0;
  double peak_memory_mib = 0.0;  // of all its processes together; shared pages count once (Pss)
  int exit_code = 0;
};

// Runs this program with these arguments, its output thrown away, and waits for it. Memory is looked at 50
// times a second, which takes time of its own: 0 unless it is wanted.
[[nodiscard]] Expected<ProcessCost> measureProcess(const std::vector<std::string>& arguments,
                                                   bool wants_memory);

}  // namespace ssrkit
