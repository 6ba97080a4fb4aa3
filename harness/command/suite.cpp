#include "command/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iterator>
#include <utility>

#include "base/check.h"
#include "check/judge.h"
#include "command/scene_geometry.h"
#include "frame/stages.h"
#include "frame/techniques.h"
#include "scene/defaults.h"
#include "scene/find_scene.h"

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

// As many frames as the test says, or as its techniques want.
Sequence sequenceOf(const TestFile& test) {
  Sequence sequence;
  sequence.time_s = test.time_s;
  sequence.time_step_s = test.time_step_s.value_or(sequence.time_step_s);
  for (const TestCase& test_case : test.cases) {
    const auto technique = findTechnique(test_case.technique);
    sequence.frame_count = std::max(sequence.frame_count, technique ? (*technique)->frame_count : 1);
  }
  sequence.frame_count = test.frames.value_or(sequence.frame_count);
  return sequence;
}

}  // namespace

Expected<std::unique_ptr<Suite>> Suite::create(SuiteOptions options) {
  std::unique_ptr<Suite> suite(new Suite(std::move(options)));
  for (const std::string& device : suite->options_.devices) {
    const auto entry = findDevice(device);
    if (!entry) {
      return tl::make_unexpected(entry.error());
    }
    suite->workers_.emplace(device, Worker(**entry, {.shader_root = suite->options_.shader_root}));
  }
  return suite;
}

Expected<std::map<std::string, DeviceInfo>> Suite::devices() {
  std::map<std::string, std::future<Expected<DeviceInfo>>> starting;
  for (auto& [id, worker] : workers_) {
    starting.emplace(id,
                     std::async(std::launch::async, [&worker_ref = worker] { return worker_ref.info(); }));
  }
  std::map<std::string, DeviceInfo> infos;
  for (auto& [id, future] : starting) {
    auto info = future.get();
    if (!info) {
      return tl::make_unexpected(info.error());
    }
    infos.emplace(id, std::move(*info));
  }
  return infos;
}

Expected<SceneSource> Suite::source(const std::string& name_or_path,
                                    const std::filesystem::path& scenes_root) {
  const auto file = findScene(name_or_path, scenes_root);
  if (!file) {
    return tl::make_unexpected(file.error());
  }
  SceneSource source{
      .name = file->stem().string(), .file = *file, .gbuffer = nullptr, .camera_name = "", .defaults = {}};
  const std::filesystem::path defaults_file = defaultsFileOf(*file);
  std::error_code ignored;
  if (std::filesystem::exists(defaults_file, ignored)) {
    const auto defaults = loadSceneDefaults(defaults_file);
    if (!defaults) {
      return tl::make_unexpected(defaults.error());
    }
    source.defaults = defaults->parameters;
  }
  return source;
}

Job Suite::jobFor(const TestFile& test, const SceneSource& source, Size size) const {
  Job job;
  job.id = fmt::format("{} {}x{}", source.name, size.width, size.height);
  job.scene_file = source.file;
  job.camera_name = test.camera.empty() ? source.camera_name : test.camera;
  job.mirror_material = options_.mirror_material;
  job.environment = options_.environment;
  job.size = size;
  job.frame = test.frame;
  job.sequence = sequenceOf(test);
  job.timing.rounds = test.rounds;
  job.replacements = options_.replacements;
  job.shader_root = options_.shader_root;
  for (const TestCase& test_case : test.cases) {
    for (const std::string& name : test.stages) {
      // Known, and the values are in range: both were checked when the file or the command line was read.
      const auto stage = findStage(name);
      SSRKIT_CHECK(stage.has_value());
      job.traces.push_back({.stage = name,
                            .parameters = askedParameters(source.defaults, **stage, test_case.parameters),
                            .technique = test_case.technique});
    }
  }
  if (source.gbuffer != nullptr) {
    job.gbuffer = source.gbuffer->images;
    job.gbuffer_camera = source.gbuffer->camera;
    job.size = source.gbuffer->camera.size;
  }
  return job;
}

void Suite::runCell(const TestFile& test, const std::string& device, const Job& job, const std::string& input,
                    SceneRun& run) {
  CellRun& cell = run.cells.emplace_back();
  cell.device = device;
  cell.size = job.size;
  cell.input = input;
  for (const TestCase& test_case : test.cases) {
    cell.case_of_trace.insert(cell.case_of_trace.end(), test.stages.size(), test_case.name);
  }
  if (options_.progress) {
    options_.progress(fmt::format("{} {} on {}", test.id, job.id, device));
  }
  JobOutcome outcome = workers_.at(device).run(job, options_.limits);
  if (auto* result = std::get_if<JobResult>(&outcome)) {
    cell.result = std::move(*result);
    cell.mask = maskOf(cell.result->images);
  } else if (auto* error = std::get_if<Error>(&outcome)) {
    cell.error = std::move(*error);
  } else {
    cell.death = std::get<WorkerDeath>(std::move(outcome));
  }
}

SceneRun Suite::run(const TestFile& test, const SceneSource& source) {
  SceneRun run{.source = &source, .cells = {}, .answers = {}, .checks = {}};
  const std::vector<std::string>& devices = test.devices.empty() ? options_.devices : test.devices;
  std::vector<Size> sizes = test.sizes.empty() ? std::vector{options_.size} : test.sizes;
  if (source.gbuffer != nullptr) {
    sizes = {source.gbuffer->camera.size};
  }
  for (const Size size : sizes) {
    for (const std::string& device : devices) {
      runCell(test, device, jobFor(test, source, size), "", run);
    }
    if (!test.input.empty()) {
      runOverInput(test, devices, jobFor(test, source, size), run);
    }
  }
  const bool wants_oracle = options_.always_oracle || needsOracle(test);
  const bool wants_depth = needsGeometry(test, false);
  const bool wants_geometry = needsGeometry(test, true) || wants_depth;
  const Sequence sequence = sequenceOf(test);
  SceneGeometry geometry(source.file, timeOf(sequence, sequence.frame_count - 1));
  for (CellRun& cell : run.cells) {
    if (cell.result) {
      cell.truth_of_trace.assign(cell.result->traces.size(), nullptr);
    }
    if (wants_oracle) {
      addTruths(cell);
    }
    const bool is_first = options_.geometry_of_first_device && &cell == &run.cells.front();
    if (source.gbuffer == nullptr && (wants_geometry || is_first)) {
      addGeometry(cell, geometry, wants_depth);
    }
    addAnswers(cell, run.answers);
  }
  judge(test, source, run);
  return run;
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

void Suite::judge(const TestFile& test, const SceneSource& source, SceneRun& run) const {
  const auto add = [&](CheckResult check, const std::string& name) {
    check.id = test.id + "." + name;
    check.scene = source.name;
    check.metric = name;
    check.repro = options_.command;
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
  // A cell that never came back has been reported: what it leaves unanswered is not missing once more.
  const std::vector<CheckResult> checks =
      ssrkit::judge(test, source.name, run.answers, [&](const Answer&) { return options_.command; });
  std::ranges::copy_if(checks, std::back_inserter(run.checks), [&](const CheckResult& check) {
    return all_came_back || check.outcome != Outcome::kMissing;
  });
}

}  // namespace ssrkit
