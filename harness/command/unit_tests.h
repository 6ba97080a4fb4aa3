// The tests that CTest knows: unit and end-to-end.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"

namespace ssrkit {

struct UnitTestCounts {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t skipped = 0;
};

// Runs those whose name matches the filter (* stands for any text), on all cores, and shows the output of
// failures.
[[nodiscard]] Expected<UnitTestCounts> runUnitTests(const std::filesystem::path& build,
                                                    const std::string& filter);

// Prints their names.
[[nodiscard]] Expected<void> listUnitTests(const std::filesystem::path& build, const std::string& filter);

}  // namespace ssrkit
