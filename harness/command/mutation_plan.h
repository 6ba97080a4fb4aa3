// Which checks look at what a mutant changes.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "command/gtest_runs.h"
#include "command/mutant_battery.h"
#include "command/mutant_shaders.h"
#include "mutation/mutant.h"

namespace ssrkit {

// The instance of unit tests that runs over mutants of shaders and of the frame.
inline constexpr const char* kShaderDevice = "gl_osmesa";

// What all runners share, read once.
struct MutationPlan {
  KitPaths paths;
  std::vector<BatteryTest> battery;
  ShaderUses uses;
  UnitTestRooms rooms;
  // The unit tests that a shader's mutants name, with the entry files that these mutants concern: they are
  // run over every mutant of one of these files.
  std::map<std::string, std::set<std::string>> unit_entries;
  std::set<std::string> suite;  // every check of the battery, and every unit test that a mutant names
  bool first_kill = false;      // go on with the next mutant once one check has noticed
};

[[nodiscard]] Expected<MutationPlan> makePlan(const KitPaths& paths, const std::vector<Mutant>& mutants,
                                              const std::filesystem::path& scratch);

using TestsByRoom = std::map<std::string, std::set<std::string>>;

// The checks that look at what a mutant changes.
struct MutantChecks {
  std::set<std::size_t> battery;  // tests, by index
  TestsByRoom unit;
  TestsByRoom last_resort;  // of the harness: the room's other tests, run where those above noticed nothing
  std::string instance;     // of the unit tests; empty: all
};

[[nodiscard]] MutantChecks checksFor(const Mutant& mutant, const MutationPlan& plan);

}  // namespace ssrkit
