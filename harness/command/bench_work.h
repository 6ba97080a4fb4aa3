// What the parts of `ssrkit bench` share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/bench.h"
#include "command/kit_paths.h"
#include "command/progress_line.h"
#include "command/run_request.h"
#include "command/suite.h"
#include "report/bench_report.h"

namespace ssrkit {

// Devices, stages and sizes take turns so often in the rounds of passes and of scaling.
inline constexpr int kBenchParts = 3;

struct BenchWork {
  const BenchOptions& options;
  const KitPaths& paths;
  ProgressLine& progress;
  std::vector<PeerShader> peers;
  RunRequest request;  // scenes, sizes and a test that times and checks nothing
};

// Workers for these devices. `variables` are set over the devices' own environment; the rounds of a test are
// drawn in `parts` parts that take turns.
[[nodiscard]] Expected<std::unique_ptr<Suite>> benchSuite(
    const BenchWork& work, const std::vector<std::string>& devices, int parts,
    const std::vector<std::pair<std::string, std::string>>& variables = {});

// bench_passes.cpp: every pass of every trace, the native peers beside them, and the starts. What went wrong
// is among the run's checks: those are added to `failures`.
[[nodiscard]] Expected<void> timePasses(const BenchWork& work, Suite& suite, BenchReport& report,
                                        std::vector<CheckResult>& failures);

// bench_starts.cpp: a fresh process of each device draws the scene once, with and without caches.
[[nodiscard]] Expected<std::vector<BenchStart>> measureStarts(const BenchWork& work,
                                                              const SceneSource& source,
                                                              std::vector<CheckResult>& failures);

// bench_scaling.cpp: one axis, over the request's scenes, stages and devices.
[[nodiscard]] Expected<std::vector<BenchScaling>> measureScaling(const BenchWork& work,
                                                                 const std::string& axis,
                                                                 std::vector<CheckResult>& failures);

// bench_gates.cpp: every file of tests/gates.
[[nodiscard]] Expected<std::vector<CheckResult>> measureGates(const BenchWork& work);

// bench_process.cpp: every file of tests/gates/process, which hold whole runs of the program to their bounds.
[[nodiscard]] Expected<std::vector<CheckResult>> measureProcessGates(const BenchWork& work);

// bench_peer.cpp: the shaders that the files of --peer describe (docs/peers.md).
[[nodiscard]] Expected<std::vector<PeerShader>> readPeers(const BenchOptions& options);

// bench_baseline.cpp: an earlier run's series, and where they were measured.
struct BenchBaseline {
  std::string file;
  BenchMachine machine;
  std::vector<BenchSeries> series;
  std::vector<std::string> replacements;
};
[[nodiscard]] Expected<BenchBaseline> readBaseline(const std::filesystem::path& file);

// Fails when the two were not measured on one machine: their times say nothing about each other.
[[nodiscard]] Expected<void> checkSameMachine(const BenchBaseline& baseline, const BenchMachine& machine);

// Fails when no series can be compared.
[[nodiscard]] Expected<BenchComparison> compareWith(const BenchBaseline& baseline,
                                                    const std::vector<BenchSeries>& series);

}  // namespace ssrkit
