#include "command/mutation_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text.h"
#include "command/mutant_build.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

bool intersect(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::ranges::any_of(a, [&](const std::string& element) { return b.contains(element); });
}

Expected<void> checkKiller(const Mutant& mutant, const MutationPlan& plan) {
  if (mutant.is_wheat || plan.suite.contains(mutant.killed_by)) {
    return {};
  }
  std::vector<std::string> known;
  std::ranges::transform(plan.rooms, std::back_inserter(known), [](const auto& test) { return test.first; });
  known.insert(known.end(), plan.suite.begin(), plan.suite.end());
  const auto nearest = nearestName(mutant.killed_by, known);
  return inputError(fmt::format("read the mutant '{}'", mutant.name),
                    fmt::format("there is no check '{}'", mutant.killed_by), mutant.where,
                    nearest ? fmt::format("did you mean '{}'?", *nearest)
                            : "name a unit test, or a check of tests/mutants/battery");
}

}  // namespace

Expected<MutationPlan> makePlan(const KitPaths& paths, const std::vector<Mutant>& mutants,
                                const fs::path& scratch) {
  MutationPlan plan{.paths = paths};
  auto battery = loadBattery(paths);
  auto uses = battery ? shaderUses(paths.shaders) : tl::make_unexpected(battery.error());
  auto rooms = uses ? findUnitTests(paths.build, scratch) : tl::make_unexpected(uses.error());
  if (!rooms) {
    return tl::make_unexpected(rooms.error());
  }
  plan.battery = std::move(*battery);
  plan.uses = std::move(*uses);
  plan.rooms = std::move(*rooms);
  for (const BatteryTest& test : plan.battery) {
    const std::vector<std::string> checks = checksOf(test.file);
    plan.suite.insert(checks.begin(), checks.end());
  }
  for (const Mutant& mutant : mutants) {
    if (!plan.rooms.contains(mutant.killed_by)) {
      continue;
    }
    plan.suite.insert(mutant.killed_by);
    if (const auto used = plan.uses.find(mutant.edit.file); used != plan.uses.end()) {
      plan.unit_entries[mutant.killed_by].insert(used->second.begin(), used->second.end());
    }
  }
  for (const Mutant& mutant : mutants) {
    if (const auto known = checkKiller(mutant, plan); !known) {
      return tl::make_unexpected(known.error());
    }
  }
  return plan;
}

MutantChecks checksFor(const Mutant& mutant, const MutationPlan& plan) {
  MutantChecks checks;
  if (isOfHarness(mutant)) {
    const std::string room = roomOf(mutant);
    // What draws passes is one code for all devices: a second one shows no more of a mistake in it.
    checks.instance = room == "frame" ? kShaderDevice : "";
    for (const auto& [test, room_of_test] : plan.rooms) {
      if (room_of_test == room) {
        (plan.suite.contains(test) ? checks.unit : checks.last_resort)[room].insert(test);
      }
    }
    return checks;
  }
  checks.instance = kShaderDevice;
  const auto used = plan.uses.find(mutant.edit.file);
  if (used == plan.uses.end()) {
    return checks;
  }
  for (const auto& [test, entries] : plan.unit_entries) {
    if (intersect(entries, used->second)) {
      checks.unit[plan.rooms.at(test)].insert(test);
    }
  }
  for (std::size_t i = 0; i < plan.battery.size(); ++i) {
    if (intersect(plan.battery[i].entries, used->second)) {
      checks.battery.insert(i);
    }
  }
  return checks;
}

}  // namespace ssrkit
