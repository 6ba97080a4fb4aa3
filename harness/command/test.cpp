#include "command/test.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "base/text.h"
#include "check/metric_table.h"
#include "check/outcome.h"
#include "check/read_expectations.h"
#include "command/kit_paths.h"
#include "command/known_names.h"
#include "command/print_checks.h"
#include "command/progress_line.h"
#include "command/run_rows.h"
#include "command/suite.h"
#include "command/unit_tests.h"
#include "report/report_files.h"
#include "report/results_json.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

constexpr const char* kStandard = "standard";  // applies to every `run`; by itself it has nothing to run on

Expected<void> checkTags(const std::vector<std::string>& tags, const std::vector<TestFile>& files) {
  std::set<std::string> carried;
  for (const TestFile& file : files) {
    carried.insert(file.tags.begin(), file.tags.end());
  }
  const std::vector<std::string> known(carried.begin(), carried.end());
  for (const std::string& tag : tags) {
    if (!carried.contains(tag)) {
      return inputError("run the tests", fmt::format("no expectation file carries the tag '{}'", tag),
                        "--tag", "the tags are " + joinNames(known));
    }
  }
  return {};
}

bool carriesOneOf(const std::vector<std::string>& tags, const TestFile& file) {
  return tags.empty() || std::ranges::any_of(tags, [&](const std::string& tag) {
           return std::ranges::find(file.tags, tag) != file.tags.end();
         });
}

Expected<std::vector<TestFile>> expectationFiles(const TestOptions& options, const KitPaths& paths) {
  auto files = loadExpectations(paths.expectations, knownNames(paths));
  if (!files) {
    return files;
  }
  std::erase_if(*files, [](const TestFile& file) { return file.id == kStandard; });
  if (const auto checked = checkTags(options.tags, *files); !checked) {
    return tl::make_unexpected(checked.error());
  }
  std::erase_if(*files, [&](const TestFile& file) {
    return fnmatch(options.filter.c_str(), file.id.c_str(), 0) != 0 || !carriesOneOf(options.tags, file);
  });
  return files;
}

// Costs and convergence say something even where they hold: their figures are shown.
bool isMeasurement(const CheckResult& check) {
  const MetricRow* const metric = findMetric(check.metric);
  return !check.message.empty() && metric != nullptr && metric->shows_figure;
}

// One line a test and scene; the whole message of what failed.
void printScene(const TestFile& test, const SceneRun& run, std::chrono::duration<double> time) {
  const auto failed = static_cast<std::size_t>(
      std::ranges::count_if(run.checks, [](const CheckResult& check) { return isFailure(check.outcome); }));
  fmt::print("{:<6}{:<44}{:<10}{:>5} checks{:>8.1f} s\n", failed > 0 ? "FAIL" : "ok", test.id,
             run.source->name, run.checks.size(), time.count());
  for (const CheckResult& check : run.checks) {
    if (isFailure(check.outcome) || check.outcome == Outcome::kInconclusive) {
      printCheck(check);
    } else if (isMeasurement(check)) {
      fmt::print("      {:<36} {:<12} {}\n", check.id, check.device, check.message);
    }
  }
  std::fflush(stdout);
}

std::vector<std::string> namedDevices(const std::vector<TestFile>& files) {
  std::vector<std::string> devices;
  for (const TestFile& file : files) {
    devices.insert(devices.end(), file.devices.begin(), file.devices.end());
    if (!file.input.empty()) {
      devices.push_back(file.input);
    }
  }
  return devices;
}

// What each trace cost, and the passes of its frame.
void addTraces(const SceneRun& run, RunReport& report) {
  std::ranges::move(runRows(run), std::back_inserter(report.rows));
  for (const CellRun& cell : run.cells) {
    if (cell.result) {
      report.frames.push_back({run.source->name, cell.device, cell.size, cell.result->frame_passes});
    }
  }
}

Expected<std::vector<CheckResult>> runExpectations(const TestOptions& options, const KitPaths& paths,
                                                   const std::vector<TestFile>& files, RunReport& report) {
  ProgressLine progress;
  auto suite = Suite::create({.shader_root = paths.shaders,
                              .scenes_root = paths.scenes,
                              .goldens_root = paths.goldens,
                              .devices = options.devices,
                              .further_devices = namedDevices(files),
                              .size = {640, 360},
                              .mirror_material = "",
                              .environment = std::nullopt,
                              .replacements = {},
                              .limits = {},
                              .always_oracle = false,
                              .geometry_of_first_device = false,
                              .command = "",
                              .progress = [&](const std::string& text) { progress.show(text); }});
  if (!suite) {
    return tl::make_unexpected(suite.error());
  }
  const auto infos = (*suite)->devices();
  if (!infos) {
    return tl::make_unexpected(infos.error());
  }
  for (const auto& [id, info] : *infos) {
    report.devices.push_back({info.identity, info.traits});
  }
  std::vector<CheckResult> checks;
  for (const TestFile& test : files) {
    (*suite)->setCommand(fmt::format("./ssrkit test --only expect --filter {}", test.id));
    const bool all = test.scenes.size() == 1 && test.scenes.front() == "all";
    for (const std::string& scene : all ? builtInScenes(paths.scenes) : test.scenes) {
      const auto source = Suite::source(scene, paths.scenes);
      if (!source) {
        return tl::make_unexpected(source.error());
      }
      const auto start = std::chrono::steady_clock::now();
      const SceneRun run = (*suite)->run(test, *source);
      progress.clear();
      if (!options.json) {
        printScene(test, run, std::chrono::steady_clock::now() - start);
      }
      addTraces(run, report);
      checks.insert(checks.end(), run.checks.begin(), run.checks.end());
      const CheckResult none{
          .id = test.id, .scene = scene, .outcome = Outcome::kFail, .message = "no check was made"};
      if (run.checks.empty()) {
        checks.push_back(none);
        if (!options.json) {
          printCheck(none);
        }
      }
    }
  }
  return checks;
}

}  // namespace

Expected<int> testCommand(const TestOptions& options) {
  const KitPaths paths = kitPaths();
  if (options.only == "unit" && !options.tags.empty()) {
    return inputError("run the tests", "--tag and --only unit were both given", "",
                      "unit tests carry no tags, give one of the two");
  }
  const bool wants_unit = (options.only.empty() && options.tags.empty()) || options.only == "unit";
  const bool wants_expect = options.only.empty() || options.only == "expect";
  auto files = wants_expect ? expectationFiles(options, paths)
                            : Expected<std::vector<TestFile>>(std::vector<TestFile>{});
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  if (options.list) {
    for (const TestFile& file : *files) {
      fmt::print("{:<44}{}\n", file.id, file.about);
    }
    const auto listed = wants_unit ? listUnitTests(paths.build, options.filter) : Expected<void>{};
    return listed ? Expected<int>(0) : tl::make_unexpected(listed.error());
  }
  RunReport report{.kit_version = SSRKIT_VERSION,
                   .started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))),
                   .command = options.command};
  if (wants_unit) {
    const auto counts = runUnitTests(paths.build, options.filter,
                                     options.json ? UnitTestOutput::kToFile : UnitTestOutput::kShown);
    if (!counts) {
      return tl::make_unexpected(counts.error());
    }
    report.unit_tests = *counts;
  }
  if (!files->empty()) {
    auto checks = runExpectations(options, paths, *files, report);
    if (!checks) {
      return tl::make_unexpected(checks.error());
    }
    report.checks = std::move(*checks);
    if (const auto written = writeReportFiles(options.out, report); !written) {
      return tl::make_unexpected(written.error());
    }
  }
  const std::vector<Outcome> outcomes = outcomesOf(report);
  if (outcomes.empty()) {
    return inputError("run the tests",
                      fmt::format("no test {}matches '{}'",
                                  options.tags.empty() ? "" : "of the tags that were given ", options.filter),
                      "--filter", "./ssrkit test --list shows their names");
  }
  if (options.json) {
    fmt::print("{}", resultsJson(report));
    return exitCode(outcomes);
  }
  // On a line of its own: the closing line is read by programs.
  if (const auto noisy = std::ranges::count(outcomes, Outcome::kInconclusive); noisy > 0) {
    fmt::print("\n{} inconclusive: too noisy to judge on this machine\n", noisy);
  }
  fmt::print("\n{}\n", closingLine(outcomes));
  return exitCode(outcomes);
}

}  // namespace ssrkit
