
#include "command/bench_work.h"
#include "command/empty_folder.h"

namespace ssrkit {

namespace {

std::int64_t firstDraws(const JobResult& result) {
  std::int64_t sum = 0;
  const auto add = [&sum](const std::vector<PassReport>& passes) {
    for (const PassReport& pass : passes) {
      sum += pass.cold.wall_ns;
    }
  };
  add(result.frame_passes);
  for (const TraceResult& trace : result.traces) {
    add(trace.passes);
  }
  return sum;
}

Expected<void> measureStart(const BenchWork& work, const SceneSource& source, const std::string& device,
                            const std::string& cache, std::vector<BenchStart>& starts,
                            std::vector<CheckResult>& failures) {
  std::vector<std::pair<std::string, std::string>> variables;
  if (!cache.empty()) {
    variables = {{"XDG_CACHE_HOME", cache}, {"MESA_SHADER_CACHE_DIR", cache}};
  }
  auto suite = benchSuite(work, {device}, 1, variables);
  auto infos = suite ? (*suite)->devices() : tl::make_unexpected(suite.error());
  if (!infos) {
    return tl::make_unexpected(infos.error());
  }
  TestFile once = work.request.test;
  once.rounds = 0;
  const SceneRun run = (*suite)->run(once, source);
  failures.insert(failures.end(), run.checks.begin(), run.checks.end());
  const std::optional<JobResult>& result = run.cells.front().result;
  if (result) {
    starts.push_back({.scene = source.name,
                      .device = device,
                      .has_caches = cache.empty(),
                      .create_ns = infos->at(device).create_ns,
                      .compile_ns = result->setup.compile_ns,
                      .pipeline_ns = result->setup.pipeline_ns,
                      .first_ns = firstDraws(*result)});
  }
  return {};
}

}  // namespace

Expected<std::vector<BenchStart>> measureStarts(const BenchWork& work, const SceneSource& source,
                                                std::vector<CheckResult>& failures) {
  std::vector<BenchStart> starts;
  for (const std::string& device : work.request.devices) {
    const auto empty = EmptyFolder::create();
    auto done = empty ? measureStart(work, source, device, empty->path(), starts, failures)
                      : tl::make_unexpected(empty.error());
    // The rounds before this have filled the caches.
    done = done ? measureStart(work, source, device, "", starts, failures) : done;
    if (!done) {
      return tl::make_unexpected(done.error());
    }
  }
  return starts;
}

}  // namespace ssrkit
