// Tests that are made of others: the same jobs, drawn again to find out what their answers do not tell.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"

namespace ssrkit {

struct ExtraPasses {
  bool safety = false;  // reads outside arrays, loops that are cut
  std::string
      validate;  // "core,sync,gpu" or a part of it: what Vulkan's validation layer says; empty: nothing
};

// What is wrong with the text as ExtraPasses::validate; empty where it is a list of checks.
[[nodiscard]] std::string problemWithChecks(const std::string& text);

// For each test that asks one question in one way (tests of variants ask theirs again already) one that is
// called "safety.ID", and "validate.core.ID" and so on for `vulkan_devices`. They draw the test's cases and
// expect nothing of the answers; every device renders its own G-buffer.
[[nodiscard]] std::vector<TestFile> extraTests(std::span<const TestFile> tests, const ExtraPasses& passes,
                                               const std::vector<std::string>& vulkan_devices);

// What a test of that id is drawn again for; nothing for a test of a file.
[[nodiscard]] ExtraPasses passesOf(std::string_view test_id);
[[nodiscard]] bool isExtraTest(std::string_view test_id);

// The command that runs these cells alone.
[[nodiscard]] std::string conformCommandFor(const std::vector<std::string>& cell_ids);

}  // namespace ssrkit
