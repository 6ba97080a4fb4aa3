#include "command/conform.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/json_text.h"
#include "command/conform_plan.h"
#include "command/conform_report.h"
#include "command/conform_work.h"
#include "command/output_folder.h"
#include "conform/inputs.h"
#include "conform/plan.h"

namespace ssrkit {

namespace {

int laneCount(const ConformOptions& options) {
  constexpr int kMost = 4;
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return options.jobs > 0 ? options.jobs : std::min(processors, kMost);
}

// Lanes share the processors: a rasteriser's threads beyond that only get into each other's way. Before any
// worker starts, and before there are threads.
void shareProcessors(int lanes) {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  constexpr int kKeepTheUsersOwn = 0;
  setenv("LP_NUM_THREADS", std::to_string(std::max(1, processors / lanes)).c_str(), kKeepTheUsersOwn);
}

int printList(const ConformPlan& plan, bool json) {
  nlohmann::ordered_json ids = nlohmann::ordered_json::array();
  for (const Cell& cell : plan.own) {
    ids.push_back(cellId(cell));
    if (!json) {
      fmt::print("{}\n", cellId(cell));
    }
  }
  if (json) {
    fmt::print("{}\n", jsonText(ids, 1));
  }
  return 0;
}

// Every cell of every software device.
bool isWhole(const ConformOptions& options) {
  return options.devices.empty() && options.scenes.empty() && options.filters.empty() &&
         options.excludes.empty() && options.rerun_failed.empty() && options.shard == "1/1";
}

MakeSuite suiteMaker(const ConformPlan& plan, const KitPaths& paths, const JobLimits& limits) {
  const std::vector<std::string> devices = devicesOf(plan);
  return [devices, paths, limits] {
    return Suite::create({.shader_root = paths.shaders,
                          .scenes_root = paths.scenes,
                          .goldens_root = paths.goldens,
                          .devices = devices,
                          .size = {64, 36},
                          .limits = limits,
                          .wants_ledger = true,
                          .tests_in_job_ids = true});
  };
}

// Whether another device of the plan is held against it.
bool isReference(const ConformPlan& plan, const std::string& device) {
  return std::ranges::any_of(plan.own, [&](const Cell& cell) {
    const auto references = referencesOf(plan.test(cell), cell.device);
    return cell.device != device && std::ranges::find(references, device) != references.end();
  });
}

// Starts every device once. What is absent costs its own cells: an optional device's are skipped, those of
// one that must be there are errors, and `required_absent` gets the first reason. One that others are held
// against ends the run.
Expected<void> meetDevices(Suite& suite, const ConformPlan& plan, ConformRun& run) {
  std::map<std::string, std::future<Expected<DeviceInfo>>> starting;
  for (const std::string& id : devicesOf(plan)) {
    starting.emplace(id, std::async(std::launch::async, [&suite, id] { return suite.device(id); }));
  }
  std::map<std::string, Expected<DeviceInfo>> infos;
  for (auto& [id, future] : starting) {
    infos.emplace(id, future.get());
  }
  for (const auto& [id, info] : infos) {
    if (info) {
      run.manifest.devices.push_back({info->identity, info->traits});
      continue;
    }
    Error error = info.error();
    run.manifest.absent.emplace_back(id, sentence(error));
    const bool is_optional = std::ranges::find(plan.optional, id) != plan.optional.end();
    const bool is_reference = isReference(plan, id);
    if (!is_optional || is_reference) {
      error.attempted = fmt::format("use the device '{}': {}", id, error.attempted);
      run.required_absent = run.required_absent.value_or(error);
    }
    if (is_reference) {
      return tl::make_unexpected(std::move(error));
    }
  }
  return {};
}

// The folder that GoldenShelf reads; empty where the test asks for no golden.
std::filesystem::path goldensOf(const TestFile& test, const SceneSource& scene, const KitPaths& paths) {
  const bool asks_for_any = std::ranges::any_of(test.expectations, [](const Expectation& expectation) {
    return expectation.truth.kind == TruthKind::kGolden;
  });
  return asks_for_any ? paths.goldens / test.id / scene.name : std::filesystem::path();
}

Expected<void> hashInputs(const KitPaths& paths, ConformRun& run) {
  auto hasher = InputHasher::create("/proc/self/exe", paths.shaders);
  if (!hasher) {
    return tl::make_unexpected(hasher.error());
  }
  for (const Cell& cell : run.plan->own) {
    const TestFile& test = run.plan->test(cell);
    const SceneSource& scene = run.plan->source(cell);
    CellInputs inputs{.id = cellId(cell),
                      .test_file = test.file,
                      .scene_file = scene.file,
                      .goldens = goldensOf(test, scene, paths)};
    std::vector<std::string> ids = referencesOf(test, cell.device);
    ids.push_back(cell.device);
    for (const DeviceRow& device : run.manifest.devices) {
      if (std::ranges::find(ids, device.identity.id) != ids.end()) {
        inputs.devices.push_back(device.identity);
      }
    }
    const auto hash = hasher->inputs(inputs);
    if (!hash) {
      return tl::make_unexpected(hash.error());
    }
    run.inputs.emplace(inputs.id, *hash);
  }
  return {};
}

Manifest manifestOf(const ConformOptions& options, const ConformPlan& plan) {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  Manifest manifest{.kit_version = SSRKIT_VERSION,
                    .started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now)),
                    .command = options.command,
                    .shard = plan.shard};
  for (const Cell& cell : plan.cells) {
    manifest.cells.push_back(cellId(cell));
    manifest.shard_of_cell.push_back(shardOf(cell, plan.shard.count));
  }
  return manifest;
}

Expected<void> prepare(ConformRun& run, const KitPaths& paths, const MakeSuite& make_suite) {
  const auto suite = make_suite();
  return suite ? meetDevices(**suite, *run.plan, run)
                     .and_then([&] { return hashInputs(paths, run); })
                     .and_then([&] { return run.store.write(run.manifest); })
                     .and_then([&] { return divideWork(run); })
               : tl::make_unexpected(suite.error());
}

}  // namespace

Expected<int> conformCommand(const ConformOptions& options) {
  const KitPaths paths = kitPaths();
  const auto plan = makePlan(options, paths);
  const auto known = readKnownFailures(options.baseline, paths);
  if (!plan || !known) {
    return tl::make_unexpected(!plan ? plan.error() : known.error());
  }
  if (options.list) {
    return printList(*plan, options.json);
  }
  const int lanes = laneCount(options);
  shareProcessors(lanes);
  ConformRun run{.options = &options,
                 .plan = &*plan,
                 .store = CellStore(options.out),
                 .manifest = manifestOf(options, *plan)};
  const MakeSuite make_suite = suiteMaker(*plan, paths, options.limits.jobLimits());
  const auto done =
      prepareFolder(options.out).and_then([&] { return prepare(run, paths, make_suite); }).and_then([&] {
        return workThrough(run, make_suite, lanes);
      });
  if (!done) {
    return tl::make_unexpected(done.error());
  }
  ConformReport report{.manifest = run.manifest,
                       .known_failures = *known,
                       .is_whole = isWhole(options),
                       .command = options.command,
                       .out = options.out,
                       .json = options.json,
                       .failure = run.required_absent};
  for (const Cell& cell : plan->own) {
    report.records.push_back(std::move(run.records.at(cellId(cell))));
  }
  return finishConform(std::move(report));
}

}  // namespace ssrkit
