// Holds mutants and wheats against the checks that look at what they change.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "command/mutation_plan.h"
#include "mutation/kill_matrix.h"

namespace ssrkit {

// One after the other, with workers of its own that live on from one mutant to the next.
class MutantRunner {
 public:
  // `scratch` is a folder of this runner's own.
  MutantRunner(const MutationPlan& plan, std::filesystem::path scratch);

  [[nodiscard]] MutantRun run(const Mutant& mutant);

  // The kit itself under the checks of all these mutants, as a wheat: it must pass every one of them. Not the
  // last resort: there it is held against those tests alone that noticed something.
  [[nodiscard]] MutantRun runKit(const std::vector<Mutant>& mutants);

  // The kit itself under unit tests too, on all of their instances.
  void holdKitAgainst(const std::set<std::string>& tests, MutantRun& kit);

 private:
  Expected<void> hold(const Mutant& mutant, MutantRun& result);
  Expected<void> runUnit(const TestsByRoom& tests_by_room, const std::string& wanted_instance,
                         const std::filesystem::path& shaders, const std::filesystem::path& program,
                         MutantRun& result);
  // The test that makes the check `first` goes first.
  Expected<void> runBattery(const MutantChecks& checks, const std::filesystem::path& shaders,
                            const std::string& first, MutantRun& result);
  void note(const std::map<std::string, std::string>& said, MutantRun& result) const;
  [[nodiscard]] bool isDone(const MutantRun& result) const;

  const MutationPlan& plan_;
  std::filesystem::path scratch_;
  std::unique_ptr<Suite> suite_;  // made at the first use
};

}  // namespace ssrkit
