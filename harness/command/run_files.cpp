#include "command/run_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/share_out.h"
#include "check/geometry_image.h"
#include "command/parameters_file.h"
#include "command/run_sheet.h"
#include "frame/frame_images.h"
#include "frame/frame_read_back.h"
#include "image/colour_map.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/ray_record.h"
#include "report/geometry_picture.h"
#include "spaces/camera_json.h"

namespace ssrkit {

namespace {

using Write = std::function<Expected<void>()>;

// Runs the writes in so many lanes; the first error is the answer, and no further write is started after it.
Expected<void> writeAll(const std::vector<Write>& writes, int lane_count) {
  std::optional<Error> failure;
  std::mutex mutex;
  forEachInParallel(static_cast<int>(writes.size()), lane_count, [&](int i) {
    {
      const std::lock_guard lock(mutex);
      if (failure) {
        return;
      }
    }
    if (auto written = writes[static_cast<std::size_t>(i)](); !written) {
      const std::lock_guard lock(mutex);
      if (!failure) {
        failure = std::move(written.error());
      }
    }
  });
  return failure ? Expected<void>(tl::make_unexpected(std::move(*failure))) : Expected<void>{};
}

Image* imageOf(TraceResult& trace, const std::string& name) {
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

// In the order in which they are made: first what is drawn from several images and records, then each of
// these by itself, which is given up with it. Of a large frame they are most of what a run holds.
struct Writes {
  std::vector<Write> of_several;
  std::vector<Write> of_one;
};

template <class T>
T takeOut(T& value) {
  return std::exchange(value, T{});
}

void addImageWrite(const std::filesystem::path& file, Image& image, Writes& writes) {
  writes.of_one.push_back([file, &image] { return writeExr(file, takeOut(image)); });
}

void addTraceWrites(const std::filesystem::path& folder, TraceResult& trace, Writes& writes) {
  Image* const composite = imageOf(trace, "composite");
  Image* const reflection = imageOf(trace, "reflection");
  if (composite != nullptr && reflection != nullptr) {
    writes.of_several.push_back([=] { return writePng(folder / "composite.png", toneMap(*composite)); });
    writes.of_one.push_back([=] {
      const Image colour = colourFile(takeOut(*composite), takeOut(*reflection));
      return writeExr(folder / "color.exr", colour);
    });
  }
  for (auto& [name, image] : trace.images) {
    if (&image != composite && &image != reflection) {
      addImageWrite(folder / (name + ".exr"), image, writes);
    }
  }
  writes.of_one.push_back([=, &trace] {
    const Image image = toImage(takeOut(trace.record));
    return writeExr(folder / "hit.exr", image);
  });
}

void addCellWrites(const std::filesystem::path& folder, CellRun& cell, const SceneRun& run,
                   const std::vector<RunRow>& rows, Writes& writes) {
  JobResult& result = *cell.result;
  const std::filesystem::path device_folder = folder / cell.device;
  writes.of_several.push_back([=, &cell, &run, &rows] {
    return writeSheet(device_folder / "contact_sheet.png", cell, run.source->name, rows);
  });
  writes.of_several.push_back(
      [=, &lit = result.images.at("lit")] { return writePng(device_folder / "lit.png", toneMap(lit)); });
  for (auto& [name, image] : result.images) {
    addImageWrite(device_folder / frameImageRow(name).folder / (name + ".exr"), image, writes);
  }
  for (std::size_t i = 0; i < result.traces.size(); ++i) {
    addTraceWrites(device_folder / result.traces[i].stage / cell.case_of_trace[i], result.traces[i], writes);
  }
}

// The oracles' answers over the first device's G-buffer.
void addOracleWrites(const std::filesystem::path& folder, CellRun& cell, Writes& writes) {
  CellRun::Truth& truth = cell.truths.front();
  if (truth.geometry != nullptr) {
    const auto verdicts = std::make_shared<std::vector<GeometryVerdict>>();
    writes.of_several.push_back([=, &truth, &lit = cell.result->images.at("lit")] {
      *verdicts = compareWithGeometry(truth.result.record, *truth.geometry, truth.input);
      return writePng(folder / "geometry.png", geometryPicture(*truth.geometry, lit));
    });
    writes.of_one.push_back(
        [=, &truth] { return writeExr(folder / "geometry.exr", toImage(*truth.geometry, *verdicts)); });
  }
  writes.of_one.push_back([=, &truth] {
    const Image image = toImage(takeOut(truth.result));
    return writeExr(folder / "hit.exr", image);
  });
}

// What the cells of all devices share.
void addSharedWrites(const std::filesystem::path& folder, CellRun& cell, const SceneRun& run,
                     Writes& writes) {
  writes.of_several.push_back(
      [=, &cell] { return writeFileAtomically(folder / "camera.json", toJson(cell.result->camera)); });
  writes.of_several.push_back([=, &run] { return writeParametersFile(folder, run.source->defaults); });
  if (!cell.truths.empty()) {
    addOracleWrites(folder / "oracle", cell, writes);
  }
}

}  // namespace

Expected<void> writeSceneFiles(const std::filesystem::path& folder, SceneRun run,
                               const std::vector<RunRow>& rows) {
  Writes writes;
  const std::filesystem::path scene_folder = folder / run.source->name;
  bool has_shared_files = false;
  bool is_large = false;
  for (CellRun& cell : run.cells) {
    if (!cell.result || cell.error) {
      continue;
    }
    addCellWrites(scene_folder, cell, run, rows, writes);
    is_large = is_large || isLargeFrame(cell.size);
    if (!has_shared_files) {
      has_shared_files = true;
      addSharedWrites(scene_folder, cell, run, writes);
    }
  }
  // What is written of a large frame takes as much memory again, file by file.
  const int lane_count = is_large ? 1 : 0;
  auto written = writeAll(writes.of_several, lane_count);
  return written ? writeAll(writes.of_one, lane_count) : written;
}

}  // namespace ssrkit
