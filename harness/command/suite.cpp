#include "command/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "base/check.h"
#include "check/judge.h"
#include "command/half_buffers.h"
#include "command/native_cells.h"
#include "command/suite_jobs.h"
#include "frame/frame_read_back.h"
#include "frame/variants.h"

namespace ssrkit {

namespace {

bool needsOracle(const TestFile& test) {
  return std::ranges::any_of(test.expectations, [](const Expectation& expectation) {
    return expectation.truth.kind == TruthKind::kOracle || row(expectation.metric).needs_oracle ||
           expectation.truth.kind == TruthKind::kGeometry;
  });
}

// Of the records, or of the image dist_view.
bool needsGeometry(const TestFile& test, bool of_record) {
  return std::ranges::any_of(test.expectations, [&](const Expectation& expectation) {
    return expectation.truth.kind == TruthKind::kGeometry && (expectation.buffer == "hit") == of_record;
  });
}

// A timing that a busy machine made too noisy to judge is measured once more, over this many times the
// rounds. A verdict, good or bad, is never asked again.
constexpr int kLongerTiming = 2;

bool isInconclusive(const CheckResult& check) {
  return check.outcome == Outcome::kInconclusive;
}

}  // namespace

Expected<std::unique_ptr<Suite>> Suite::create(SuiteOptions options) {
  std::unique_ptr<Suite> suite(new Suite(std::move(options)));
  std::vector<std::string> ids = suite->options_.devices;
  ids.insert(ids.end(), suite->options_.further_devices.begin(), suite->options_.further_devices.end());
  if (auto made = suite->workers_.create(ids, {.shader_root = suite->options_.shader_root,
                                               .environment = suite->options_.environment_variables});
      !made) {
    return tl::make_unexpected(made.error());
  }
  return suite;
}

void Suite::runCell(const TestFile& test, const std::string& device, const Job& job, const std::string& input,
                    SceneRun& run) {
  CellRun& cell = run.cells.emplace_back();
  cell.device = device;
  cell.size = job.size;
  cell.input = input;
  cell.variant = job.variant;
  for (const TestCase& test_case : casesOf(test, job.variant)) {
    cell.cases.push_back(test_case.name);
    cell.case_of_trace.insert(cell.case_of_trace.end(), test.stages.size() + options_.peers.size(),
                              test_case.name);
  }
  if (options_.progress) {
    options_.progress(fmt::format("{} {} on {}", test.id, job.id, device));
  }
  const auto start = std::chrono::steady_clock::now();
  JobOutcome outcome = workers_.at(device, environmentOf(job.variant)).run(job, options_.limits);
  cell.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (auto* result = std::get_if<JobResult>(&outcome)) {
    cell.result = std::move(*result);
    cell.mask = maskOf(cell.result->images);
  } else if (auto* error = std::get_if<Error>(&outcome)) {
    cell.error = std::move(*error);
  } else {
    cell.death = std::get<WorkerDeath>(std::move(outcome));
  }
  const bool has_extra = options_.extra.safety || !options_.extra.validate.empty();
  if (has_extra && job.variant.empty()) {
    addExtraPasses(test, job, cell, run);
  }
}

SceneRun Suite::run(const TestFile& test, const SceneSource& source) {
  SceneRun run = runOnce(test, source);
  if (test.rounds > 0 && std::ranges::any_of(run.checks, isInconclusive)) {
    TestFile longer = test;
    longer.rounds *= kLongerTiming;
    run = runOnce(longer, source);
  }
  return run;
}

WantedTruths Suite::wantedOf(const TestFile& test, const SceneSource& source, bool is_first) const {
  const bool wants_depth = needsGeometry(test, false);
  const bool wants_geometry = needsGeometry(test, true) || wants_depth;
  return {.oracle = options_.always_oracle || needsOracle(test),
          .geometry = source.gbuffer == nullptr &&
                      (wants_geometry || (is_first && options_.geometry_of_first_device)),
          .true_depth = wants_depth};
}

SceneRun Suite::runOnce(const TestFile& test, const SceneSource& source) {
  SceneRun run{.source = &source,
               .cells = {},
               .answers = {},
               .seen_answers = {},
               .extra_checks = {},
               .checks = {},
               .ledger = {}};
  const Sequence sequence = sequenceOf(test);
  SceneGeometry geometry(source.file, timeOf(sequence, sequence.frame_count - 1));
  TruthLane truths(geometry, test.rounds > 0);
  const std::vector<Size> sizes = test.sizes.empty() ? std::vector{options_.size} : test.sizes;
  for (const Size size : source.gbuffer != nullptr ? std::vector{source.gbuffer->camera.size} : sizes) {
    runSize(test, source, size, truths, run);
  }
  // None without rounds: nothing is to be timed, and the lane reads the cells meanwhile.
  for (int part = 1; part < options_.parts; ++part) {
    if (roundsOfPart(test.rounds, part, options_.parts) > 0) {
      runAgain(test, source, part, run);
    }
  }
  if (std::ranges::any_of(run.cells, [](const CellRun& cell) { return isLargeFrame(cell.size); })) {
    workers_.rest();
  }
  truths.finish();
  for (const CellRun& cell : run.cells) {
    addAnswers(cell, run.answers);
  }
  addSeenAnswers(variantsOf(test), run.seen_answers, run.answers);
  judge(test, source, run);
  if (options_.wants_ledger) {
    addToLedger(run.answers, halfBuffers(), run.ledger);
  }
  return run;
}

// The cells of one size, and their truths.
void Suite::runSize(const TestFile& test, const SceneSource& source, Size size, TruthLane& truths,
                    SceneRun& run) {
  const std::size_t first = run.cells.size();
  std::size_t asked = first;
  const auto askAboutNewCells = [&] {
    for (; asked < run.cells.size(); ++asked) {
      truths.add(run.cells[asked], wantedOf(test, source, asked == 0));
    }
  };
  const std::vector<std::string>& named = test.devices.empty() ? options_.devices : test.devices;
  const std::vector<std::string> devices = devicesAmong(named);
  for (const std::string& variant : variantsOf(test)) {
    const Job job = jobFor(test, source, options_, size, variant);
    // Every variant is given the same G-buffer, the one of the first.
    const bool renders_own = test.input.empty() || variant == test.cases.front().variant;
    for (const std::string& device : renders_own ? devices : std::vector<std::string>{}) {
      if (test.input.empty() || device == test.input || comparesWithRendered(test)) {
        runCell(test, device, job, "", run);
        askAboutNewCells();
      }
    }
    if (!test.input.empty()) {
      runOverInput(test, devices, job, run);
      askAboutNewCells();
    }
  }
  if (test.input.empty() && first < run.cells.size()) {
    const int rounds = roundsOfPart(test.rounds, 0, options_.parts);
    addNativeCells(nativePeersAmong(named), run.cells[first], rounds, run);
    askAboutNewCells();
  }
}

// Every device over the G-buffer that the test's input device rendered.
void Suite::runOverInput(const TestFile& test, const std::vector<std::string>& devices, Job job,
                         SceneRun& run) {
  const auto given = std::ranges::find_if(run.cells, [&](const CellRun& cell) {
    return cell.device == test.input && cell.size == job.size && cell.input.empty();
  });
  if (given == run.cells.end() || !given->result) {
    return;
  }
  job.gbuffer = given->result->images;
  job.gbuffer_camera = given->result->camera;
  for (const std::string& device : devices) {
    runCell(test, device, job, test.input, run);
  }
}

// By the device's own key: a worker that has answered knows its identity.
GoldenLookup Suite::goldenLookup(GoldenShelf& shelf) {
  return [this, &shelf](const Expectation& expectation, const Answer& answer) -> const Answer* {
    const auto info = workers_.at(answer.device, {}).info();
    return info ? shelf.find(expectation, answer, goldenKeyOf(info->identity)) : nullptr;
  };
}

void Suite::judge(const TestFile& test, const SceneSource& source, SceneRun& run) {
  const auto add = [&](CheckResult check, const std::string& name) {
    check.id = test.id + "." + name;
    check.scene = source.name;
    check.metric = name;
    check.repro = commandFor(check.device);
    run.checks.push_back(std::move(check));
  };
  bool all_came_back = true;
  for (const CellRun& cell : run.cells) {
    if (!cell.result || cell.error) {
      all_came_back = false;
      add(failureOf(cell), "runs");
      continue;
    }
    for (CheckResult& check : messagesOf(cell)) {
      add(std::move(check), "driver_messages");
    }
    for (CheckResult& check : limitedTracesOf(cell)) {
      add(std::move(check), "loop_limiter");
    }
  }
  for (const CheckResult& check : run.extra_checks) {
    add(check, check.metric);
  }
  auto shelf = GoldenShelf::load(options_.goldens_root, test, source.name);
  if (!shelf) {
    add({.message = sentence(shelf.error())}, "goldens");
  }
  // A cell that never came back has been reported: what it leaves unanswered is not missing once more.
  const std::vector<CheckResult> checks = ssrkit::judge(
      test, source.name, run.answers, [&](const Answer& answer) { return commandFor(answer.device); },
      shelf ? goldenLookup(*shelf) : GoldenLookup{});
  std::ranges::copy_if(checks, std::back_inserter(run.checks), [&](const CheckResult& check) {
    return all_came_back || check.outcome != Outcome::kMissing;
  });
  shareTimes(run.cells, run.checks);
}

}  // namespace ssrkit
