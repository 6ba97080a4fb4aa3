// What a suite knows before it runs, and what it adds to a run: its scenes, further rounds and drawings.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <system_error>

#include "command/device_threads.h"
#include "command/extra_passes.h"
#include "command/native_cells.h"
#include "command/suite.h"
#include "command/suite_jobs.h"
#include "scene/defaults.h"
#include "scene/find_scene.h"

namespace ssrkit {

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

// Adds the rounds of one more part to every cell that came back.
void Suite::runAgain(const TestFile& test, const SceneSource& source, int part, SceneRun& run) {
  for (CellRun& cell : run.cells) {
    if (!cell.result || cell.error || !cell.input.empty()) {
      continue;
    }
    const int rounds = roundsOfPart(test.rounds, part, options_.parts);
    if (!cell.native_peer.empty()) {
      timeNativeAgain(cell, rounds);
      continue;
    }
    Job job = jobFor(test, source, options_, cell.size, cell.variant);
    job.want_gbuffer = false;
    job.timing.rounds = rounds;
    if (options_.progress) {
      options_.progress(fmt::format("{} {} on {}, again", test.id, job.id, cell.device));
    }
    JobOutcome outcome = workers_.at(cell.device, environmentOf(cell.variant)).run(job, options_.limits);
    if (const auto* result = std::get_if<JobResult>(&outcome)) {
      appendRounds(cell, *result);
    } else if (auto* error = std::get_if<Error>(&outcome)) {
      cell.error = std::move(*error);
    } else {
      cell.death = std::get<WorkerDeath>(std::move(outcome));
      cell.result.reset();
    }
  }
}

// Of a plain job.
void Suite::addExtraPasses(const TestFile& test, const Job& job, CellRun& cell, SceneRun& run) {
  const auto start = std::chrono::steady_clock::now();
  const auto again = [&](const std::string& variant, const Environment& environment) {
    Job other = job;
    other.variant = variant;
    other.timing.rounds = 0;
    other.id += variant.empty() ? " validated" : " " + variant;
    if (options_.progress) {
      options_.progress(fmt::format("{} {} on {}", test.id, other.id, cell.device));
    }
    return workers_.at(cell.device, environment).run(other, options_.limits);
  };
  std::ranges::move(extraChecks(cell, options_.extra, concernsOf(cell.device), again),
                    std::back_inserter(run.extra_checks));
  cell.time_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A device that does not start cuts no loops: its cells say so.
DeviceConcerns Suite::concernsOf(const std::string& device) {
  const auto info = workers_.at(device, {}).info();
  return {.is_vulkan = isVulkanDevice(device), .cuts_loops = info && info->traits.loop_cap > 0};
}

}  // namespace ssrkit
