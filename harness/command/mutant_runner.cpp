#include "command/mutant_runner.h"

#include <algorithm>
#include <chrono>

#include "command/mutant_build.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

// The device room's tests run on every software device. Each of these in a process of its own: a driver is
// chosen once a process.
const std::vector<std::string> kDeviceInstances = {kShaderDevice, "vk_lavapipe"};

// What one run of a room's test program is asked for.
struct UnitTestProcess {
  std::string room;
  std::set<std::string> tests;
  std::string instance;  // "" for all
};

std::vector<UnitTestProcess> inProcesses(const TestsByRoom& tests_by_room,
                                         const std::string& wanted_instance) {
  std::vector<UnitTestProcess> processes;
  for (const auto& [room, tests] : tests_by_room) {
    const bool one_each = room == "device" && wanted_instance.empty();
    for (const std::string& instance : one_each ? kDeviceInstances : std::vector{wanted_instance}) {
      processes.push_back({room, tests, instance});
    }
  }
  return processes;
}

}  // namespace

MutantRunner::MutantRunner(const MutationPlan& plan, fs::path scratch)
    : plan_(plan), scratch_(std::move(scratch)) {}

bool MutantRunner::isDone(const MutantRun& result) const {
  return plan_.first_kill && !killersOf(result).empty();
}

void MutantRunner::note(const std::map<std::string, std::string>& said, MutantRun& result) const {
  for (const auto& [check, complaint] : said) {
    // Of a room's other tests only those that noticed something are worth a column.
    if (!complaint.empty() || plan_.suite.contains(check)) {
      result.noticed[check] = result.noticed[check] || !complaint.empty();
    }
    if (!complaint.empty()) {
      result.said.emplace(check, complaint);
    }
  }
}

Expected<void> MutantRunner::runUnit(const TestsByRoom& tests_by_room, const std::string& wanted_instance,
                                     const fs::path& shaders, const fs::path& program, MutantRun& result) {
  for (const auto& [room, tests, instance] : inProcesses(tests_by_room, wanted_instance)) {
    UnitTestRun run{.program = program.empty() ? plan_.paths.build / "bin" / ("test_" + room) : program,
                    .tests = {tests.begin(), tests.end()},
                    .instance = instance,
                    .environment = {},
                    .scratch = scratch_};
    if (!shaders.empty()) {
      run.environment.emplace_back("SSRKIT_SHADERS", shaders.string());
    }
    const auto said = runUnitTests(run);
    if (!said) {
      return tl::make_unexpected(said.error());
    }
    note(*said, result);
    if (isDone(result)) {
      break;
    }
  }
  return {};
}

Expected<void> MutantRunner::runBattery(const MutantChecks& checks, const fs::path& shaders,
                                        const std::string& first, MutantRun& result) {
  if (suite_ == nullptr) {
    auto suite = batterySuite(plan_.battery, plan_.paths);
    if (!suite) {
      return tl::make_unexpected(suite.error());
    }
    suite_ = std::move(*suite);
  }
  std::vector<std::size_t> order(checks.battery.begin(), checks.battery.end());
  std::stable_partition(order.begin(), order.end(), [&](std::size_t index) {
    return first.starts_with(plan_.battery[index].file.id + ".");
  });
  for (const std::size_t index : order) {
    note(runBatteryTest(*suite_, plan_.battery[index], shaders), result);
    if (isDone(result)) {
      break;
    }
  }
  return {};
}

Expected<void> MutantRunner::hold(const Mutant& mutant, MutantRun& result) {
  const fs::path folder = scratch_ / mutant.name;
  const MutantChecks checks = checksFor(mutant, plan_);
  Expected<void> done;
  if (isOfHarness(mutant)) {
    const auto program = buildMutant(mutant, plan_.paths, folder);
    done = program ? runUnit(checks.unit, checks.instance, {}, *program, result)
                   : tl::make_unexpected(program.error());
    if (done && killersOf(result).empty()) {
      done = runUnit(checks.last_resort, checks.instance, {}, *program, result);
    }
  } else {
    const auto shaders = makeMutantShaders(mutant, plan_.paths, plan_.uses, folder);
    done = shaders ? Expected<void>{} : tl::make_unexpected(shaders.error());
    // What is to notice it goes first: with first_kill nothing else has to.
    const bool unit_first = isUnitTest(mutant.killed_by);
    for (const bool unit : {unit_first, !unit_first}) {
      if (done && !isDone(result)) {
        done = unit ? runUnit(checks.unit, checks.instance, *shaders, {}, result)
                    : runBattery(checks, *shaders, mutant.killed_by, result);
      }
    }
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return done;
}

MutantRun MutantRunner::run(const Mutant& mutant) {
  MutantRun result{.mutant = mutant};
  const auto start = std::chrono::steady_clock::now();
  std::error_code failed;
  fs::create_directories(scratch_ / mutant.name, failed);
  if (const auto done = hold(mutant, result); !done) {
    result.problem = sentence(done.error());
  }
  result.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

MutantRun MutantRunner::runKit(const std::vector<Mutant>& mutants) {
  MutantRun result{.mutant = {.name = "the kit itself",
                              .is_wheat = true,
                              .about = "Nothing is changed: what fails here tells nothing of mutants."}};
  const auto start = std::chrono::steady_clock::now();
  std::map<std::string, TestsByRoom> unit_by_instance;
  MutantChecks all;
  for (const Mutant& mutant : mutants) {
    const MutantChecks checks = checksFor(mutant, plan_);
    all.battery.insert(checks.battery.begin(), checks.battery.end());
    for (const auto& [room, tests] : checks.unit) {
      unit_by_instance[checks.instance][room].insert(tests.begin(), tests.end());
    }
  }
  Expected<void> done;
  for (const auto& [instance, tests_by_room] : unit_by_instance) {
    done = done ? runUnit(tests_by_room, instance, plan_.paths.shaders, {}, result) : done;
  }
  done = done && !all.battery.empty() ? runBattery(all, plan_.paths.shaders, "", result) : done;
  if (!done) {
    result.problem = sentence(done.error());
  }
  result.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

void MutantRunner::holdKitAgainst(const std::set<std::string>& tests, MutantRun& kit) {
  TestsByRoom tests_by_room;
  for (const std::string& test : tests) {
    tests_by_room[plan_.rooms.at(test)].insert(test);
  }
  if (const auto done = runUnit(tests_by_room, "", {}, {}, kit); !done && kit.problem.empty()) {
    kit.problem = sentence(done.error());
  }
}

}  // namespace ssrkit
