// `ssrkit compare`: what people say of screen-space reflections, put to the test.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct CompareOptions {
  std::vector<std::string> claims;  // by name; empty: all of them
  std::vector<std::string> devices{"gl-osmesa", "vk-lavapipe"};
  std::filesystem::path out = "out/compare";  // claims.json, report.html
  bool list = false;                          // names instead of runs
  bool json = false;                          // claims.json on standard output in the place of the text
  std::vector<std::string> command;           // argv, for the report
};

// 0 when every claim was measured, whatever came out; 4 when a claim is inconclusive; 1 when one could not be
// measured. The last line is "N passed, N failed": claims that were settled, claims that
// could not be measured.
[[nodiscard]] Expected<int> compareCommand(const CompareOptions& options);

}  // namespace ssrkit
