#include "command/run_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "base/atomic_file.h"
#include "check/geometry_image.h"
#include "command/parameters_file.h"
#include "command/run_rows.h"
#include "frame/frame_images.h"
#include "frame/frame_read_back.h"
#include "image/colour_map.h"
#include "image/exr.h"
#include "image/png.h"
#include "report/contact_sheet.h"
#include "report/geometry_picture.h"
#include "spaces/camera_json.h"

namespace ssrkit {

namespace {

using Write = std::function<Expected<void>()>;

// Runs the writes on so many threads; the first error is the answer, and no further write is started after
// it.
Expected<void> writeAll(const std::vector<Write>& writes, unsigned thread_count) {
  std::size_t next = 0;
  std::optional<Error> failure;
  std::mutex mutex;
  const auto work = [&] {
    while (true) {
      std::unique_lock lock(mutex);
      if (failure || next == writes.size()) {
        return;
      }
      const Write& write = writes[next++];
      lock.unlock();
      if (auto written = write(); !written) {
        lock.lock();
        failure = std::move(written.error());
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < thread_count; ++i) {
      threads.emplace_back(work);
    }
  }
  return failure ? Expected<void>(tl::make_unexpected(std::move(*failure))) : Expected<void>{};
}

const Image* imageOf(const TraceResult& trace, const std::string& name) {
  const auto found = trace.images.find(name);
  return found == trace.images.end() ? nullptr : &found->second;
}

// The composite, with the reflection as a layer of its own.
Image colourFile(const Image& composite, const Image& reflection) {
  Image colour(composite.size,
               {"R", "G", "B", "reflection.R", "reflection.G", "reflection.B", "reflection.A"});
  for (std::size_t texel = 0; texel < colour.texelCount(); ++texel) {
    std::copy_n(composite.data.data() + 3 * texel, 3, colour.data.data() + 7 * texel);
    std::copy_n(reflection.data.data() + 4 * texel, 4, colour.data.data() + 7 * texel + 3);
  }
  return colour;
}

std::string thicknessText(const TraceParameters& parameters) {
  if (parameters.thickness_rel > 0.0) {
    return fmt::format("{:g} m + {:g} %", parameters.thickness_m, 100.0 * parameters.thickness_rel);
  }
  return fmt::format("{:g} m", parameters.thickness_m);
}

Expected<void> writeSheet(const std::filesystem::path& file, const CellRun& cell, const std::string& scene,
                          const std::vector<RunRow>& rows) {
  // Its glyphs are made once, a tenth of a second, and it serves one sheet at a time.
  static std::mutex painter_mutex;
  static Expected<TextPainter> painter = TextPainter::load();
  if (!painter) {
    return tl::make_unexpected(painter.error());
  }
  std::vector<std::vector<Verdict>> verdicts;
  std::vector<TraceSummary> summaries;
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    verdicts.push_back(verdictsOf(cell, i));
    summaries.push_back(summarise(cell.result->traces[i].record, verdicts.back()));
  }
  ContactSheet sheet{.scene = scene,
                     .device = cell.device,
                     .thickness = thicknessText(cell.result->traces.front().parameters),
                     .lit = &cell.result->images.at("lit"),
                     .exposure = 1.0,
                     .stages = {}};
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    const TraceResult& trace = cell.result->traces[i];
    const std::string& technique = cell.case_of_trace[i];
    SheetStage stage{.stage = technique.empty() ? trace.stage : trace.stage + " " + technique,
                     .record = &trace.record,
                     .summary = &summaries[i],
                     .composite = imageOf(trace, "composite"),
                     .verdicts = verdicts[i],
                     .cpu_ms = std::nullopt};
    const auto row = std::ranges::find_if(rows, [&](const RunRow& candidate) {
      return candidate.device == cell.device && candidate.stage == trace.stage &&
             candidate.case_name == technique;
    });
    if (row != rows.end()) {
      if (const auto cost = traceCost(row->passes)) {
        stage.cpu_ms = cost->cpu_ms;
      }
    }
    sheet.stages.push_back(stage);
  }
  const std::lock_guard lock(painter_mutex);
  return writeContactSheet(file, sheet, *painter);
}

void addTraceWrites(const std::filesystem::path& folder, const TraceResult& trace,
                    std::vector<Write>& writes) {
  writes.push_back([=, &trace] { return writeExr(folder / "hit.exr", toImage(trace.record)); });
  const Image* const composite = imageOf(trace, "composite");
  const Image* const reflection = imageOf(trace, "reflection");
  if (composite != nullptr && reflection != nullptr) {
    writes.push_back([=] { return writeExr(folder / "color.exr", colourFile(*composite, *reflection)); });
    writes.push_back([=] { return writePng(folder / "composite.png", toneMap(*composite)); });
  }
  for (const auto& [name, image] : trace.images) {
    if (&image != composite && &image != reflection) {
      writes.push_back(
          [file = folder / (name + ".exr"), &picture = image] { return writeExr(file, picture); });
    }
  }
}

void addCellWrites(const std::filesystem::path& folder, const CellRun& cell, const SceneRun& run,
                   const std::vector<RunRow>& rows, std::vector<Write>& writes) {
  const JobResult& result = *cell.result;
  const std::filesystem::path device_folder = folder / cell.device;
  writes.push_back([=, &cell, &run, &rows] {
    return writeSheet(device_folder / "contact_sheet.png", cell, run.source->name, rows);
  });
  for (const auto& [name, image] : result.images) {
    writes.push_back([file = device_folder / frameImageRow(name).folder / (name + ".exr"), &picture = image] {
      return writeExr(file, picture);
    });
  }
  writes.push_back(
      [=, &lit = result.images.at("lit")] { return writePng(device_folder / "lit.png", toneMap(lit)); });
  for (std::size_t i = 0; i < result.traces.size(); ++i) {
    addTraceWrites(device_folder / result.traces[i].stage / cell.case_of_trace[i], result.traces[i], writes);
  }
}

// The oracles' answers over the first device's G-buffer.
void addOracleWrites(const std::filesystem::path& folder, const CellRun::Truth& truth, const Image& lit,
                     std::vector<Write>& writes) {
  writes.push_back([=, &truth] { return writeExr(folder / "hit.exr", toImage(truth.result.record)); });
  if (truth.geometry != nullptr) {
    writes.push_back([=, &truth] {
      const auto verdicts = compareWithGeometry(truth.result.record, *truth.geometry, truth.input);
      return writeExr(folder / "geometry.exr", toImage(*truth.geometry, verdicts));
    });
    writes.push_back([=, &truth, &lit] {
      return writePng(folder / "geometry.png", geometryPicture(*truth.geometry, lit));
    });
  }
}

}  // namespace

Expected<void> writeSceneFiles(const std::filesystem::path& folder, const SceneRun& run,
                               const std::vector<RunRow>& rows) {
  std::vector<Write> writes;
  const std::filesystem::path scene_folder = folder / run.source->name;
  bool has_shared_files = false;
  bool is_large = false;
  for (const CellRun& cell : run.cells) {
    if (!cell.result || cell.error) {
      continue;
    }
    addCellWrites(scene_folder, cell, run, rows, writes);
    is_large = is_large || isLargeFrame(cell.size);
    if (!has_shared_files) {
      has_shared_files = true;
      writes.push_back([&cell, scene_folder] {
        return writeFileAtomically(scene_folder / "camera.json", toJson(cell.result->camera));
      });
      writes.push_back(
          [&run, scene_folder] { return writeParametersFile(scene_folder, run.source->defaults); });
      if (!cell.truths.empty()) {
        addOracleWrites(scene_folder / "oracle", cell.truths.front(), cell.result->images.at("lit"), writes);
      }
    }
  }
  // What is written of a large frame takes as much memory again, file by file.
  return writeAll(writes, is_large ? 1U : std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace ssrkit
