#include "command/bench_work.h"
#include "command/native_cells.h"
#include "command/run_rows.h"

namespace ssrkit {

namespace {

// What the request times, and the native peers beside its devices.
TestFile withNativePeers(const BenchWork& work) {
  TestFile test = work.request.test;
  test.devices = work.request.devices;
  const std::vector<std::string> peers = nativePeersHere();
  test.devices.insert(test.devices.end(), peers.begin(), peers.end());
  return test;
}

}  // namespace

Expected<void> timePasses(const BenchWork& work, Suite& suite, BenchReport& report,
                          std::vector<CheckResult>& failures) {
  std::vector<RunRow> rows;
  std::vector<FrameRow> frames;
  const TestFile test = withNativePeers(work);
  for (const SceneSource& scene : work.request.scenes) {
    const SceneRun run = suite.run(test, scene);
    failures.insert(failures.end(), run.checks.begin(), run.checks.end());
    const std::vector<RunRow> of_scene = runRows(run);
    rows.insert(rows.end(), of_scene.begin(), of_scene.end());
    for (const CellRun& cell : run.cells) {
      if (cell.error) {
        return tl::make_unexpected(*cell.error);
      }
      if (cell.result) {
        frames.push_back({scene.name, cell.device, cell.size, cell.result->frame_passes});
      }
    }
  }
  report.series = benchSeries(frames, rows);
  report.over_natives = ratiosOverNatives(report.series, nativePeersHere());
  if (!work.peers.empty()) {
    report.answers = benchAnswers(rows);
  }
  auto starts = measureStarts(work, work.request.scenes.front(), failures);
  if (!starts) {
    return tl::make_unexpected(starts.error());
  }
  report.starts = std::move(*starts);
  return {};
}

}  // namespace ssrkit
