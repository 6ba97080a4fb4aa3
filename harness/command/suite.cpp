#include "command/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iterator>
#include <utility>

#include "check/judge.h"
#include "frame/stages.h"
#include "scene/defaults.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// Loops are cut by Mesa at 65,535 iterations without a word; a ray that comes near has met the limiter.
constexpr std::uint32_t kLimiterSteps = 65000;

bool needsOracle(const TestFile& test) {
  return std::ranges::any_of(test.expectations, [](const Expectation& expectation) {
    return expectation.truth.kind == TruthKind::kOracle || expectation.metric == Metric::kConvergence;
  });
}

Image maskOf(const JobResult& result) {
  const auto material = result.images.find("material");
  Image mask;
  if (material == result.images.end()) {
    return mask;
  }
  mask = Image(material->second.size, {"mask"});
  for (std::size_t texel = 0; texel < mask.texelCount(); ++texel) {
    mask.data[texel] = material->second.data[texel * material->second.channelCount() + 2];
  }
  return mask;
}

// The oracle looks at these alone: cases that differ in other parameters share its answer.
bool sameForOracle(const TraceParameters& a, const TraceParameters& b) {
  return a.thickness_m == b.thickness_m && a.thickness_rel == b.thickness_rel &&
         a.max_distance_m == b.max_distance_m && a.origin_bias == b.origin_bias &&
         a.lookup_budget == b.lookup_budget;
}

std::vector<TimeSample> samplesOf(const PassReport& report) {
  std::vector<TimeSample> samples;
  for (const PassTime& time : report.steady) {
    samples.push_back(
        {.cpu_ns = static_cast<double>(time.cpu_ns), .wall_ns = static_cast<double>(time.wall_ns)});
  }
  return samples;
}

std::string deathText(const WorkerDeath& death) {
  std::string text = death.kind == WorkerDeath::Kind::kTimeout
                         ? fmt::format("the worker was stopped by its time limit (signal {})", death.signal)
                     : death.signal != 0
                         ? fmt::format("the worker died of signal {}", death.signal)
                         : std::string("the worker ended by itself");
  text +=
      fmt::format(" while it was at: {}", death.last_progress.empty() ? "its start" : death.last_progress);
  if (!death.stderr_tail.empty()) {
    text += "\n" + death.stderr_tail;
  }
  return text;
}

CheckResult cellFailure(const TestFile& test, const SceneSource& source, const CellRun& cell,
                        const std::string& command) {
  CheckResult result{.id = test.id + ".runs",
                     .scene = source.name,
                     .device = cell.device,
                     .stage = "",
                     .size = cell.size,
                     .case_name = "",
                     .outcome = Outcome::kError,
                     .metric = "runs",
                     .value = std::nullopt,
                     .max = std::nullopt,
                     .min = std::nullopt,
                     .unit = "",
                     .message = "",
                     .repro = command};
  if (cell.error) {
    result.message = sentence(*cell.error);
  } else if (cell.death) {
    result.outcome = cell.death->kind == WorkerDeath::Kind::kTimeout ? Outcome::kTimeout : Outcome::kCrash;
    result.message = deathText(*cell.death);
  }
  return result;
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
  job.size = size;
  job.timing.rounds = test.rounds;
  job.replacements = options_.replacements;
  job.shader_root = options_.shader_root;
  for (const TestCase& test_case : test.cases) {
    TraceParameters parameters = source.defaults;
    for (const auto& [name, value] : test_case.parameters) {
      // Parsed once before, when the file or the command line was read.
      SSRKIT_CHECK(setParameter(parameters, name, value, test.file).has_value());
    }
    for (const std::string& stage : test.stages) {
      job.traces.push_back({.stage = stage, .parameters = parameters, .want_color = options_.want_images});
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
    cell.mask = maskOf(*cell.result);
  } else if (auto* error = std::get_if<Error>(&outcome)) {
    cell.error = std::move(*error);
  } else {
    cell.death = std::get<WorkerDeath>(std::move(outcome));
  }
}

void Suite::addTruths(const TestFile& test, CellRun& cell) const {
  if (!cell.result) {
    return;
  }
  cell.truth_of_trace.assign(cell.result->traces.size(), nullptr);
  const auto dist_view = cell.result->images.find("dist_view");
  const auto normal_view = cell.result->images.find("normal_view");
  if (!(needsOracle(test) || options_.always_oracle) || dist_view == cell.result->images.end() ||
      normal_view == cell.result->images.end()) {
    return;
  }
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    const TraceParameters& parameters = cell.result->traces[i].parameters;
    auto truth = std::ranges::find_if(cell.truths, [&](const CellRun::Truth& known) {
      return sameForOracle(known.input.parameters, parameters);
    });
    if (truth == cell.truths.end()) {
      const OracleInput input{.camera = &cell.result->camera,
                              .dist_view = &dist_view->second,
                              .normal_view = &normal_view->second,
                              .mask = &cell.mask,
                              .parameters = parameters};
      auto result = traceOracle(input);
      if (!result) {
        cell.error = result.error();
        return;
      }
      cell.truths.push_back({input, std::move(*result)});
      truth = std::prev(cell.truths.end());
    }
    cell.truth_of_trace[i] = &*truth;
  }
}

void Suite::addAnswers(const CellRun& cell, SceneRun& run) const {
  if (!cell.result || cell.error) {
    return;
  }
  Answer frame{};
  frame.device = cell.device;
  frame.size = cell.size;
  frame.input = cell.input;
  for (const auto& [name, image] : cell.result->images) {
    frame.images.emplace(name, &image);
  }
  run.answers.push_back(frame);
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    const TraceResult& trace = cell.result->traces[i];
    Answer answer = frame;
    answer.stage = trace.stage;
    answer.case_name = cell.case_of_trace[i];
    answer.parameters = trace.parameters;
    answer.record = &trace.record;
    if (const CellRun::Truth* truth = cell.truth_of_trace[i]) {
      answer.oracle_input = &truth->input;
      answer.oracle = &truth->result;
    }
    if (trace.composite) {
      answer.images.emplace("composite", &*trace.composite);
      answer.images.emplace("reflection", &*trace.reflection);
    }
    for (const PassReport& report : trace.passes) {
      answer.times.emplace(report.pass, samplesOf(report));
    }
    run.answers.push_back(std::move(answer));
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
    if (test.input.empty()) {
      continue;
    }
    const auto given = std::ranges::find_if(run.cells, [&](const CellRun& cell) {
      return cell.device == test.input && cell.size == size && cell.input.empty();
    });
    if (given == run.cells.end() || !given->result) {
      continue;
    }
    Job job = jobFor(test, source, size);
    job.gbuffer = given->result->images;
    job.gbuffer_camera = given->result->camera;
    for (const std::string& device : devices) {
      runCell(test, device, job, test.input, run);
    }
  }
  for (CellRun& cell : run.cells) {
    addTruths(test, cell);
    addAnswers(cell, run);
  }
  judge(test, source, run);
  return run;
}

void Suite::judge(const TestFile& test, const SceneSource& source, SceneRun& run) const {
  for (const CellRun& cell : run.cells) {
    if (!cell.result || cell.error) {
      run.checks.push_back(cellFailure(test, source, cell, options_.command));
      continue;
    }
    CheckResult messages = cellFailure(test, source, cell, options_.command);
    messages.id = test.id + ".driver_messages";
    messages.metric = "driver_messages";
    messages.outcome = Outcome::kFail;
    for (const std::string& message : cell.result->messages) {
      messages.message = message;
      run.checks.push_back(messages);
    }
    for (const TraceResult& trace : cell.result->traces) {
      const bool is_cut = std::ranges::any_of(trace.record.rays, [](const RayHit& ray) {
        return std::max(ray.steps, ray.lookups) >= kLimiterSteps;
      });
      if (is_cut) {
        messages.id = test.id + ".loop_limiter";
        messages.stage = trace.stage;
        messages.metric = "loop_limiter";
        messages.outcome = Outcome::kLimiter;
        messages.message = fmt::format(
            "a ray took {} steps or more: Mesa cuts loops at 65,535 iterations without a word, so the answer "
            "is not "
            "the shader's own; bound the loop",
            kLimiterSteps);
        run.checks.push_back(messages);
      }
    }
  }
  const std::vector<CheckResult> checks =
      ssrkit::judge(test, source.name, run.answers, [&](const Answer&) { return options_.command; });
  // A cell that never came back has been reported: what it leaves unanswered is not missing once more.
  const bool all_came_back =
      std::ranges::all_of(run.cells, [](const CellRun& cell) { return cell.result && !cell.error; });
  std::ranges::copy_if(checks, std::back_inserter(run.checks), [&](const CheckResult& check) {
    return all_came_back || check.outcome != Outcome::kMissing;
  });
}

}  // namespace ssrkit
