// `ssrkit mutate`: whether the checks notice known mistakes, and nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct MutateOptions {
  std::string filter = "*";                  // of names: * stands for any text
  std::filesystem::path out = "out/mutate";  // mutate.json, kill_matrix.csv, report.html
  bool first_kill = false;                   // stop at the first check that notices
  bool list = false;                         // names instead of runs
  bool json = false;                         // mutate.json on standard output in the place of the text
  std::vector<std::string> command;          // argv, for the report
};

// 0 when every mutant was noticed and no wheat was, else 1. The last line is "N passed, N failed": mutants
// and wheats that came out as they are to, and those that did not.
[[nodiscard]] Expected<int> mutateCommand(const MutateOptions& options);

}  // namespace ssrkit
