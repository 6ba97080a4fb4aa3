#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "check/read_expectations.h"
#include "command/bench_work.h"
#include "command/known_names.h"
#include "command/native_cells.h"
#include "frame/replacements.h"
#include "native/trace.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

constexpr int kGateParts = 5;  // devices and sizes take turns so often
constexpr int kMostNamedThreads = 2;

// Gates may hold a device against itself with another number of threads, and against native peers.
KnownNames namesForGates(const KitPaths& paths) {
  KnownNames known = knownNames(paths);
  const std::vector<std::string> plain = known.devices;
  for (const std::string& device : plain) {
    for (int threads = 1; threads <= kMostNamedThreads; ++threads) {
      known.devices.push_back(fmt::format("{}@{}", device, threads));
    }
  }
  for (const NativePeer& peer : nativePeers()) {
    known.devices.push_back(peer.name);
  }
  return known;
}

// What this CPU has no instructions for is taken out of the file, and told as skipped.
std::vector<CheckResult> skipOtherCpus(TestFile& file) {
  std::vector<CheckResult> skipped;
  for (const NativePeer& peer : nativePeers()) {
    if (peer.runs_here) {
      continue;
    }
    std::erase(file.devices, peer.name);
    std::erase_if(file.expectations, [&](const Expectation& expectation) {
      const bool is_against = expectation.truth == Truth{TruthKind::kCross, peer.name};
      if (is_against) {
        CheckResult check{.id = file.id + "." + expectation.name, .outcome = Outcome::kSkip};
        check.metric = row(expectation.metric).name;
        check.message = fmt::format("skip: {}: this CPU has no {}", check.id, peer.instruction_set);
        skipped.push_back(std::move(check));
      }
      return is_against;
    });
  }
  return skipped;
}

std::vector<std::string> devicesOf(const std::vector<TestFile>& files,
                                   const std::vector<std::string>& run_devices) {
  std::set<std::string> devices;
  for (const TestFile& file : files) {
    const std::vector<std::string>& of_file = file.devices.empty() ? run_devices : file.devices;
    const std::vector<std::string> workers = devicesAmong(of_file);
    devices.insert(workers.begin(), workers.end());
  }
  return {devices.begin(), devices.end()};
}

}  // namespace

Expected<std::vector<CheckResult>> measureGates(const BenchWork& work) {
  auto files = loadExpectations(work.paths.gates, namesForGates(work.paths));
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  const auto suite = benchSuite(work, devicesOf(*files, work.request.devices), kGateParts);
  if (!suite) {
    return tl::make_unexpected(suite.error());
  }
  auto of_processes = measureProcessGates(work);
  if (!of_processes) {
    return of_processes;
  }
  std::vector<CheckResult> checks = std::move(*of_processes);
  std::set<std::string> drawn_passes;
  for (TestFile& file : *files) {
    const std::vector<CheckResult> skipped = skipOtherCpus(file);
    checks.insert(checks.end(), skipped.begin(), skipped.end());
    file.rounds = file.rounds > 0 ? work.options.rounds.value_or(file.rounds) : 0;
    const bool all = file.scenes == std::vector<std::string>{"all"};
    for (const std::string& scene : all ? builtInScenes(work.paths.scenes) : file.scenes) {
      const auto source = Suite::source(scene, work.paths.scenes);
      if (!source) {
        return tl::make_unexpected(source.error());
      }
      const SceneRun run = (*suite)->run(file, *source);
      checks.insert(checks.end(), run.checks.begin(), run.checks.end());
      for (const CellRun& cell : run.cells) {
        if (cell.result) {
          drawn_passes.insert(cell.result->drawn_passes.begin(), cell.result->drawn_passes.end());
        }
      }
    }
  }
  if (const auto taken = checkReplacementsTookPlace(work.request.replacements, drawn_passes); !taken) {
    return tl::make_unexpected(taken.error());
  }
  return checks;
}

}  // namespace ssrkit
