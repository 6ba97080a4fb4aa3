#include "command/run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>
#include <future>
#include <memory>
#include <set>

#include "base/atomic_file.h"
#include "base/background.h"
#include "base/check.h"
#include "base/text.h"
#include "check/read_expectations.h"
#include "command/kit_paths.h"
#include "command/output_folder.h"
#include "command/parameters_file.h"
#include "command/print_checks.h"
#include "command/progress_line.h"
#include "command/run_files.h"
#include "command/run_request.h"
#include "command/run_rows.h"
#include "command/run_step_note.h"
#include "command/scene_geometry.h"
#include "command/suite.h"
#include "command/wanted_checks.h"
#include "frame/stages.h"
#include "report/geometry_table.h"
#include "report/pass_table.h"
#include "report/report_files.h"
#include "report/results_json.h"
#include "report/table.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// Many ties are a property of a scene at a size (an unpitched mirror floor at a height of 4k + 2 rows has
// little else), not of a tracer: a run of anybody's scene is warned of them, the built-in tests are held to
// them.
void warnOfTies(std::vector<CheckResult>& checks) {
  for (CheckResult& check : checks) {
    if (check.metric == "ambiguous_share" && check.outcome == Outcome::kFail) {
      check.outcome = Outcome::kWarn;
    }
  }
}

std::string utcNow() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

// But for errors, which are told once on standard error.
void printFailures(const std::vector<CheckResult>& checks) {
  for (const CheckResult& check : checks) {
    if (isFailure(check.outcome) && check.outcome != Outcome::kError) {
      fmt::print("\n");
      printCheck(check);
    }
  }
}

// 2 or 3 when a scene could not be run at all, for the reason that the first one gives.
int exitCodeOf(const RunReport& report, const std::optional<Error>& first_error) {
  return first_error ? exitCode(*first_error) : exitCode(outcomesOf(report));
}

void print(const RunReport& report, const RunOptions& options) {
  if (options.json) {
    fmt::print("{}", resultsJson(report));
    return;
  }
  fmt::print("{}", runTable(report.rows, {.colour = wantsColour(STDOUT_FILENO), .width = 100}));
  if (!options.frame.empty() || !options.techniques.empty()) {
    fmt::print("\n{}", passTable(report.frames, report.rows));
  }
  if (!report.geometries.empty()) {
    const bool is_one_scene = report.geometries.size() == 1;
    fmt::print("\nWhat screen space can and cannot know (docs/techniques.md)\n{}{}",
               geometryTable(report.geometries),
               is_one_scene ? "\n" + trueClassTable(report.rows) : std::string());
  }
  printFailures(report.checks);
  fmt::print("\nwritten to {}\n", options.out.string());
}

// What a run has found out so far.
struct Findings {
  RunReport report;
  std::optional<Error> first_error;
  std::set<std::string> errors;  // each told once
  std::set<std::string> notes;
};

void collect(const SceneRun& run, const std::vector<RunRow>& rows, Findings& findings) {
  RunReport& report = findings.report;
  for (const CellRun& cell : run.cells) {
    if (cell.error) {
      findings.first_error = findings.first_error.value_or(*cell.error);
      findings.errors.insert(sentence(*cell.error));
    }
    if (cell.result) {
      std::ranges::move(geometryRows(cell, run.source->name), std::back_inserter(report.geometries));
      report.frames.push_back({run.source->name, cell.device, cell.size, cell.result->frame_passes});
      for (const std::string& note : cell.result->notes) {
        findings.notes.insert(fmt::format("{}: {}", run.source->name, note));
      }
      for (const TraceResult& trace : cell.result->traces) {
        if (const auto note = shortStepNote(trace)) {
          findings.notes.insert(fmt::format("{}: {}", run.source->name, *note));
        }
      }
    }
  }
  addToLedger(run.ledger, report.ledger);
  report.rows.insert(report.rows.end(), rows.begin(), rows.end());
  report.checks.insert(report.checks.end(), run.checks.begin(), run.checks.end());
}

// Runs scene after scene; the files of one are written where the next one's drawing leaves a core idle.
Expected<void> runScenes(Suite& suite, const TestFile& test, const std::vector<SceneSource>& scenes,
                         const RunOptions& options, Findings& findings) {
  std::future<Expected<void>> writing;
  const auto finishWriting = [&]() -> Expected<void> {
    return writing.valid() ? writing.get() : Expected<void>{};
  };
  for (const SceneSource& source : scenes) {
    TestFile asked = test;
    keepWhatIsAsked(asked, source, options);
    SceneRun run = suite.run(asked, source);
    warnOfTies(run.checks);
    std::vector<RunRow> rows = runRows(run);
    collect(run, rows, findings);
    if (auto written = finishWriting(); !written) {
      return written;
    }
    const bool is_last = &source == &scenes.back();
    writing = std::async(std::launch::async, [is_last, run = std::move(run), rows = std::move(rows),
                                              out = options.out]() mutable {
      if (!is_last) {
        workInBackground();
      }
      return writeSceneFiles(out, std::move(run), rows);
    });
  }
  return finishWriting();
}

Expected<void> addDevices(Suite& suite, RunReport& report) {
  const auto infos = suite.devices();
  if (!infos) {
    return tl::make_unexpected(infos.error());
  }
  for (const auto& [id, info] : *infos) {
    report.devices.push_back({info.identity, info.traits});
  }
  return {};
}

int finish(const Findings& findings, const RunOptions& options) {
  for (const std::string& note : findings.notes) {
    fmt::print(stderr, "note: {}\n", note);
  }
  print(findings.report, options);
  std::fflush(stdout);
  for (const std::string& error : findings.errors) {
    fmt::print(stderr, "ssrkit: {}\n", error);
  }
  if (!options.json) {
    fmt::print("{}\n", closingLine(outcomesOf(findings.report)));
  }
  return exitCodeOf(findings.report, findings.first_error);
}

}  // namespace

Expected<int> runCommand(const RunOptions& options) {
  const KitPaths paths = kitPaths();
  const auto request = readRequest(options, paths);
  if (!request) {
    return tl::make_unexpected(request.error());
  }
  ProgressLine progress;
  auto suite = Suite::create({.shader_root = paths.shaders,
                              .scenes_root = paths.scenes,
                              .goldens_root = paths.goldens,
                              .devices = request->devices,
                              .size = request->size,
                              .mirror_material = options.mirror,
                              .environment = request->environment,
                              .replacements = request->replacements,
                              .limits = options.limits.jobLimits(),
                              .always_oracle = true,
                              .wants_ledger = true,
                              .geometry_of_first_device = true,
                              .extra = options.extra,
                              .command = fmt::format("{}", fmt::join(options.command, " ")),
                              .progress = [&](const std::string& text) { progress.show(text); }});
  auto done = suite ? prepareFolder(options.out) : tl::make_unexpected(suite.error());
  Findings findings{
      .report = {.kit_version = SSRKIT_VERSION, .started = utcNow(), .command = options.command}};
  done = done ? addDevices(**suite, findings.report) : done;
  done = done ? runScenes(**suite, request->test, request->scenes, options, findings) : done;
  done = done ? writeReportFiles(options.out, findings.report) : done;
  progress.clear();
  return done ? Expected<int>(finish(findings, options)) : tl::make_unexpected(done.error());
}

}  // namespace ssrkit
