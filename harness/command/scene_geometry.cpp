#include "command/scene_geometry.h"

#include <algorithm>
#include <utility>

#include "scene/load.h"
#include "scene/motion.h"

namespace ssrkit {

namespace {

// Oracle B looks at these alone.
bool sameForGeometry(const OracleInput& a, const OracleInput& b) {
  return a.dist_view == b.dist_view && a.normal_view == b.normal_view && a.mask == b.mask &&
         a.parameters.max_distance_m == b.parameters.max_distance_m &&
         a.parameters.origin_bias == b.parameters.origin_bias;
}

Expected<const GeometryResult*> geometryOf(CellRun& cell, const OracleInput& input,
                                           const TrueSurfaces& surfaces) {
  for (const CellRun::Truth& known : cell.truths) {
    if (known.geometry != nullptr && sameForGeometry(known.input, input)) {
      return known.geometry;
    }
  }
  auto result = traceGeometry(input, surfaces);
  if (!result) {
    return tl::make_unexpected(result.error());
  }
  return &cell.geometries.emplace_back(std::move(*result));
}

}  // namespace

Expected<void> SceneGeometry::load() {
  auto loaded = loadScene(scene_file_);
  if (!loaded) {
    return tl::make_unexpected(loaded.error());
  }
  if (loaded->motion != nullptr) {
    if (auto posed = poseScene(*loaded, time_s_, time_s_); !posed) {
      return posed;
    }
  }
  scene_ = std::move(*loaded);
  return {};
}

Expected<const TrueSurfaces*> SceneGeometry::surfacesFor(const glm::dmat4& view_from_world) {
  if (!scene_) {
    if (const auto loaded = load(); !loaded) {
      return tl::make_unexpected(loaded.error());
    }
  }
  if (!surfaces_ || surfaces_->viewFromWorld() != view_from_world) {
    auto built = TrueSurfaces::build(*scene_, view_from_world);
    if (!built) {
      return tl::make_unexpected(built.error());
    }
    surfaces_ = std::move(*built);
  }
  return &*surfaces_;
}

void addGeometry(CellRun& cell, SceneGeometry& geometry, bool want_depth) {
  if (!cell.result || cell.error) {
    return;
  }
  const auto surfaces = geometry.surfacesFor(cell.result->camera.view_from_world);
  if (!surfaces) {
    cell.error = surfaces.error();
    return;
  }
  for (CellRun::Truth& truth : cell.truths) {
    const auto result = geometryOf(cell, truth.input, **surfaces);
    if (!result) {
      cell.error = result.error();
      return;
    }
    truth.geometry = *result;
  }
  if (want_depth) {
    cell.true_dist_view = trueDistView(cell.result->camera, **surfaces);
  }
}

std::vector<GeometryRow> geometryRows(const CellRun& cell, const std::string& scene) {
  std::vector<GeometryRow> rows;
  for (const CellRun::Truth& truth : cell.truths) {
    if (truth.geometry == nullptr) {
      continue;
    }
    const auto trace = std::ranges::find(cell.truth_of_trace, &truth);
    const auto index = static_cast<std::size_t>(trace - cell.truth_of_trace.begin());
    const std::vector<GeometryVerdict> verdicts =
        compareWithGeometry(truth.result.record, *truth.geometry, truth.input);
    rows.push_back({.scene = scene,
                    .device = cell.device,
                    .size = cell.size,
                    .case_name = cell.case_of_trace.at(index),
                    .parameters = truth.input.parameters,
                    .counts = countByTrueClass(*truth.geometry, verdicts)});
  }
  return rows;
}

}  // namespace ssrkit
