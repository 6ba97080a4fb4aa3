#include "command/mutate.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fnmatch.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>

#include "base/atomic_file.h"
#include "base/share_out.h"
#include "check/outcome.h"
#include "command/empty_folder.h"
#include "command/kit_paths.h"
#include "command/mutant_runner.h"
#include "command/mutation_plan.h"
#include "command/progress_line.h"
#include "mutation/read_mutants.h"
#include "mutation/text_edit.h"
#include "report/mutation_report.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

Expected<std::vector<Mutant>> allMutants(const KitPaths& paths) {
  auto mutants = loadMutants(paths.mutants, false);
  auto wheats = mutants ? loadMutants(paths.wheats, true) : mutants;
  if (!wheats) {
    return wheats;
  }
  mutants->insert(mutants->end(), wheats->begin(), wheats->end());
  return mutants;
}

// An edit that does not fit is a mistake of the mutant's file: it is said before anything is run.
Expected<void> tryEdits(const std::vector<Mutant>& mutants, const KitPaths& paths) {
  for (const Mutant& mutant : mutants) {
    const auto content = readFile(mutant.shader.empty() ? paths.root / mutant.edit.file : mutant.shader);
    if (!content) {
      return tl::make_unexpected(content.error());
    }
    const auto edited = mutant.shader.empty() ? applyEdit(*content, mutant.edit, mutant.where) : content;
    if (!edited) {
      return tl::make_unexpected(edited.error());
    }
  }
  return {};
}

void printList(const std::vector<Mutant>& mutants) {
  for (const Mutant& mutant : mutants) {
    fmt::print("{:<8}{:<36}{:<42}{}\n", mutant.is_wheat ? "wheat" : "mutant", mutant.name,
               mutant.edit.file.string(), mutant.about);
  }
}

// Unit tests that no mutant names, and that noticed one all the same.
std::set<std::string> otherTestsThatNoticed(const std::vector<MutantRun>& runs, const MutationPlan& plan) {
  std::set<std::string> tests;
  for (const MutantRun& run : runs) {
    for (const std::string& check : killersOf(run)) {
      if (!plan.suite.contains(check) && plan.rooms.contains(check)) {
        tests.insert(check);
      }
    }
  }
  return tests;
}

// As many at a time as there are processors; the kit itself first, because its checks take longest.
std::vector<MutantRun> runAll(const std::vector<Mutant>& mutants, const MutationPlan& plan,
                              const fs::path& scratch, const std::function<void(const MutantRun&)>& show) {
  std::vector<MutantRun> runs(mutants.size() + 1);
  std::mutex showing;
  constexpr int kOneForEachProcessor = 0;
  shareOut(static_cast<int>(runs.size()), kOneForEachProcessor, [&](int number) -> Lane {
    const fs::path folder = scratch / std::to_string(number);
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    return [&, runner = std::make_shared<MutantRunner>(plan, folder)](int i) {
      const auto index = static_cast<std::size_t>(i);
      runs[index] = i == 0 ? runner->runKit(mutants) : runner->run(mutants[index - 1]);
      const std::lock_guard lock(showing);
      show(runs[index]);
    };
  });
  if (const auto tests = otherTestsThatNoticed(runs, plan); !tests.empty()) {
    MutantRunner(plan, scratch).holdKitAgainst(tests, runs.front());
  }
  return runs;
}

Expected<void> writeReports(const MutationReport& report, const std::string& json, const fs::path& folder) {
  auto written = writeFileAtomically(folder / "mutate.json", json);
  written = written ? writeFileAtomically(folder / "kill_matrix.csv", killMatrixCsv(report)) : written;
  return written ? writeFileAtomically(folder / "report.html", mutationHtml(report)) : written;
}

Expected<int> runAndReport(const std::vector<Mutant>& mutants, const MutationPlan& plan,
                           const fs::path& scratch, const MutateOptions& options) {
  ProgressLine progress;
  const auto started = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const auto start = std::chrono::steady_clock::now();
  std::size_t done = 0;
  const auto show = [&](const MutantRun& run) {
    progress.clear();
    if (!options.json) {
      fmt::print("{}", mutantText(run));
      std::fflush(stdout);
    }
    progress.show(fmt::format("{} of {} done", ++done, mutants.size() + 1));
  };
  MutationReport report{.kit_version = SSRKIT_VERSION,
                        .started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(started)),
                        .command = options.command,
                        .runs = runAll(mutants, plan, scratch, show),
                        .suite = {plan.suite.begin(), plan.suite.end()}};
  report.is_whole = options.filter == "*" && !options.first_kill;
  report.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.clear();
  const std::string json = mutationJson(report);
  if (const auto written = writeReports(report, json, options.out); !written) {
    return tl::make_unexpected(written.error());
  }
  std::vector<Outcome> outcomes;
  for (const MutantRun& run : report.runs) {
    outcomes.push_back(isFailure(run) ? Outcome::kFail : Outcome::kPass);
  }
  if (options.json) {
    fmt::print("{}", json);
  } else {
    fmt::print("{}written to {}\n{}\n", mutationText(report), options.out.string(), closingLine(outcomes));
  }
  return exitCode(outcomes);
}

}  // namespace

Expected<int> mutateCommand(const MutateOptions& options) {
  const KitPaths paths = kitPaths();
  const auto all = allMutants(paths);
  if (!all) {
    return tl::make_unexpected(all.error());
  }
  std::vector<Mutant> chosen;
  std::ranges::copy_if(*all, std::back_inserter(chosen), [&](const Mutant& mutant) {
    return fnmatch(options.filter.c_str(), mutant.name.c_str(), 0) == 0;
  });
  if (chosen.empty()) {
    return inputError("mutate", fmt::format("no mutant or wheat matches '{}'", options.filter), "--filter",
                      "./ssrkit mutate --list shows their names");
  }
  if (options.list) {
    printList(chosen);
    return 0;
  }
  if (const auto fits = tryEdits(chosen, paths); !fits) {
    return tl::make_unexpected(fits.error());
  }
  const auto scratch = EmptyFolder::create();
  auto plan = scratch ? makePlan(paths, *all, scratch->path()) : tl::make_unexpected(scratch.error());
  if (!plan) {
    return tl::make_unexpected(plan.error());
  }
  plan->first_kill = options.first_kill;
  return runAndReport(chosen, *plan, scratch->path(), options);
}

}  // namespace ssrkit
