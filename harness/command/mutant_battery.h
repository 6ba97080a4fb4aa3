// The expectation files that mutants are held against: tests/mutants/battery.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"
#include "command/kit_paths.h"
#include "command/suite.h"

namespace ssrkit {

struct BatteryTest {
  TestFile file;
  std::vector<SceneSource> sources;
  std::set<std::string> entries;  // the entry files of the passes that its jobs draw
};

// Reads them, with every scene that they name.
[[nodiscard]] Expected<std::vector<BatteryTest>> loadBattery(const KitPaths& paths);

// The names of the checks that a test makes: of its expectations, and of its jobs themselves.
[[nodiscard]] std::vector<std::string> checksOf(const TestFile& file);

// A suite with all devices that the tests name; its workers start when they are needed and stay.
[[nodiscard]] Expected<std::unique_ptr<Suite>> batterySuite(const std::vector<BatteryTest>& battery,
                                                            const KitPaths& paths);

// Runs one test with the shaders of `shader_root`. Empty for each check that held, over all scenes, sizes and
// stages; else the first complaint in one line.
[[nodiscard]] std::map<std::string, std::string> runBatteryTest(Suite& suite, const BatteryTest& test,
                                                                const std::filesystem::path& shader_root);

}  // namespace ssrkit
