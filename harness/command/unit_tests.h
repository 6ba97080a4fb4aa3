// The tests that CTest knows: unit and end-to-end.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "report/run_report.h"

namespace ssrkit {

enum class UnitTestOutput {
  kShown,   // where this process prints
  kToFile,  // unit-tests.log in the build folder
};

// Runs those whose name matches the filter (* stands for any text), on all cores, with the output of
// failures.
[[nodiscard]] Expected<UnitTestCounts> runUnitTests(const std::filesystem::path& build,
                                                    const std::string& filter, UnitTestOutput output);

// Prints their names.
[[nodiscard]] Expected<void> listUnitTests(const std::filesystem::path& build, const std::string& filter);

}  // namespace ssrkit
