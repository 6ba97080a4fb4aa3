// What a suite knows before it runs, and what it adds to a run: its devices, its scenes, further rounds.
#include <fmt/format.h>

#include <future>
#include <system_error>

#include "command/native_cells.h"
#include "command/suite.h"
#include "command/suite_jobs.h"
#include "scene/defaults.h"
#include "scene/find_scene.h"

namespace ssrkit {

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
    JobOutcome outcome = workerFor(cell.device, cell.variant).run(job, options_.limits);
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

}  // namespace ssrkit
