#include "command/bench.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/atomic_file.h"
#include "base/text.h"
#include "command/bench_work.h"
#include "command/print_checks.h"

namespace ssrkit {

namespace {

constexpr int kDefaultRounds = 15;

Expected<void> checkAxes(const std::vector<std::string>& axes) {
  const std::vector<std::string> known = benchAxes();
  for (const std::string& axis : axes) {
    if (std::ranges::find(known, axis) == known.end()) {
      const auto nearest = nearestName(axis, known);
      return inputError("bench", fmt::format("there is no axis '{}'", axis), "--scaling",
                        nearest ? fmt::format("did you mean '{}'?", *nearest)
                                : fmt::format("the axes are {}", joinNames(known)));
    }
  }
  return {};
}

// What `run` would be asked for, with nothing to check and rounds to time.
Expected<RunRequest> readBenchRequest(const BenchOptions& options, const KitPaths& paths) {
  RunOptions run;
  run.scenes = options.scenes;
  run.stages = options.stages;
  run.devices = options.devices;
  run.size = options.size;
  run.parameters = options.parameters;
  run.replacements = options.replacements;
  auto request = readRequest(run, paths);
  if (!request) {
    return request;
  }
  request->test.id = "bench";
  request->test.expectations.clear();
  request->test.rounds = options.rounds.value_or(kDefaultRounds);
  if (options.rooflines) {
    for (TestCase& test_case : request->test.cases) {
      test_case.technique = "rooflines";
    }
  }
  return request;
}

Expected<void> measure(const BenchWork& work, Suite& suite, BenchReport& report,
                       std::vector<CheckResult>& failures) {
  const BenchOptions& options = work.options;
  if (options.gates) {
    auto gates = measureGates(work);
    if (!gates) {
      return tl::make_unexpected(gates.error());
    }
    report.gates = std::move(*gates);
  } else if (!options.axes.empty()) {
    for (const std::string& axis : options.axes) {
      auto scalings = measureScaling(work, axis, failures);
      if (!scalings) {
        return tl::make_unexpected(scalings.error());
      }
      std::ranges::move(*scalings, std::back_inserter(report.scalings));
    }
  } else {
    return timePasses(work, suite, report, failures);
  }
  return {};
}

Expected<BenchMachine> startDevices(Suite& suite, BenchReport& report) {
  const auto infos = suite.devices();
  if (!infos) {
    return tl::make_unexpected(infos.error());
  }
  BenchMachine machine{.cpu = "", .core_count = static_cast<int>(std::thread::hardware_concurrency())};
  for (const auto& [id, info] : *infos) {
    report.devices.push_back({info.identity, info.traits});
    machine.cpu = info.identity.cpu;
  }
  return machine;
}

Expected<void> writeReport(const BenchOptions& options, const BenchReport& report) {
  auto done = writeFileAtomically(options.out / "bench.json", benchJson(report));
  done = done ? writeFileAtomically(options.out / "bench.csv", benchCsv(report)) : done;
  return done ? writeFileAtomically(options.out / "bench.html", benchHtml(report)) : done;
}

// One outcome for each series, line of a scaling, change and gate; what could not be compared is skipped.
std::vector<Outcome> outcomesOf(const BenchReport& report, const std::vector<CheckResult>& failures) {
  std::vector<Outcome> outcomes(report.scalings.size(), Outcome::kPass);
  outcomes.insert(outcomes.end(), report.baseline.empty() ? report.series.size() : 0, Outcome::kPass);
  for (const BenchChange& change : report.comparison.changes) {
    outcomes.push_back(change.move == BenchMove::kSlower         ? Outcome::kFail
                       : change.move == BenchMove::kInconclusive ? Outcome::kInconclusive
                                                                 : Outcome::kPass);
  }
  outcomes.insert(outcomes.end(), report.comparison.uncompared.size(), Outcome::kSkip);
  for (const std::vector<CheckResult>* checks : {&report.gates, &failures}) {
    for (const CheckResult& check : *checks) {
      outcomes.push_back(check.outcome);
    }
  }
  return outcomes;
}

int finish(const BenchOptions& options, const BenchReport& report, const std::vector<CheckResult>& failures) {
  std::vector<Outcome> outcomes = outcomesOf(report, failures);
  const int code = exitCode(outcomes);
  if (options.json) {
    fmt::print("{}", benchJson(report));
    return code;
  }
  fmt::print("{}", benchText(report));
  for (const std::vector<CheckResult>* checks : {&report.gates, &failures}) {
    for (const CheckResult& check : *checks) {
      if (isFailure(check.outcome)) {
        printCheck(check);
      }
    }
  }
  // On a line of its own: the closing line is read by programs.
  if (const auto noisy = std::erase(outcomes, Outcome::kInconclusive); noisy > 0) {
    fmt::print("{} inconclusive: too noisy to judge on this machine\n", noisy);
  }
  fmt::print("written to {}\n{}\n", options.out.string(), closingLine(outcomes));
  return code;
}

Expected<void> compareWithBaseline(const std::optional<BenchBaseline>& baseline, BenchReport& report) {
  if (!baseline) {
    return {};
  }
  auto comparison = compareWith(*baseline, report.series);
  if (!comparison) {
    return tl::make_unexpected(comparison.error());
  }
  report.baseline = baseline->file;
  report.baseline_replacements = baseline->replacements;
  report.comparison = std::move(*comparison);
  return {};
}

Expected<std::optional<BenchBaseline>> givenBaseline(const BenchOptions& options) {
  if (options.baseline.empty()) {
    return std::nullopt;
  }
  if (options.gates || !options.axes.empty()) {
    return inputError("bench", "--baseline compares passes, which --gates and --scaling do not time",
                      "--baseline", "give it without them");
  }
  return readBaseline(options.baseline).map([](BenchBaseline read) {
    return std::optional(std::move(read));
  });
}

}  // namespace

Expected<std::unique_ptr<Suite>> benchSuite(
    const BenchWork& work, const std::vector<std::string>& devices, int parts,
    const std::vector<std::pair<std::string, std::string>>& variables) {
  constexpr std::chrono::minutes kPatience{10};  // rounds of the slowest march on a busy machine
  const ExtraPasses none;
  return Suite::create(
      {.shader_root = work.paths.shaders,
       .scenes_root = work.paths.scenes,
       .devices = devices,
       .size = work.request.size,
       .mirror_material = "",
       .replacements = work.request.replacements,
       .tests_draw_different_passes = work.options.gates,
       .limits = {.wall = kPatience, .cpu = kPatience, .compile = kPatience, .run = kPatience},
       .parts = parts,
       .peers = work.peers,
       .environment_variables = variables,
       .always_oracle = !work.peers.empty(),
       .extra = none,
       .command = fmt::format("{}", fmt::join(work.options.command, " ")),
       .progress = [&](const std::string& text) { work.progress.show(text); }});
}

Expected<int> benchCommand(const BenchOptions& options) {
  const KitPaths paths = kitPaths();
  auto done = checkAxes(options.axes);
  auto request = done ? readBenchRequest(options, paths) : tl::make_unexpected(done.error());
  const auto baseline = request ? givenBaseline(options) : tl::make_unexpected(request.error());
  auto peers = baseline ? readPeers(options) : tl::make_unexpected(baseline.error());
  if (!peers) {
    return tl::make_unexpected(peers.error());
  }
  ProgressLine progress;
  const BenchWork work{options, paths, progress, std::move(*peers), std::move(*request)};
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  BenchReport report{.kit_version = SSRKIT_VERSION,
                     .started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now)),
                     .command = options.command,
                     .replacements = options.replacements};
  const auto suite = benchSuite(work, work.request.devices, kBenchParts);
  const auto machine = suite ? startDevices(**suite, report) : tl::make_unexpected(suite.error());
  if (!machine) {
    return tl::make_unexpected(machine.error());
  }
  report.machine = *machine;
  std::vector<CheckResult> failures;
  done = *baseline ? checkSameMachine(**baseline, *machine) : done;
  done = done ? measure(work, **suite, report, failures) : done;
  done = done ? compareWithBaseline(*baseline, report) : done;
  done = done ? writeReport(options, report) : done;
  progress.clear();
  return done ? Expected<int>(finish(options, report, failures)) : tl::make_unexpected(done.error());
}

}  // namespace ssrkit
