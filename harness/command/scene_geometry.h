// Oracle B over the cells of one scene.
#pragma once

#include <filesystem>
#include <optional>

#include "base/error.h"
#include "command/cell_run.h"
#include "oracle/true_surfaces.h"
#include "report/run_report.h"

namespace ssrkit {

// One scene's true surfaces at one time, built at the first use and anew for another view.
class SceneGeometry {
 public:
  SceneGeometry(std::filesystem::path scene_file, double time_s)
      : scene_file_(std::move(scene_file)), time_s_(time_s) {}

  [[nodiscard]] Expected<const TrueSurfaces*> surfacesFor(const glm::dmat4& view_from_world);

 private:
  [[nodiscard]] Expected<void> load();

  std::filesystem::path scene_file_;
  double time_s_ = 0.0;
  std::optional<Scene> scene_;
  std::optional<TrueSurfaces> surfaces_;
};

// Asks Oracle B about every truth of the cell, which must have been asked of Oracle A; with `want_depth` also
// what the camera truly sees. An error becomes the cell's.
void addGeometry(CellRun& cell, SceneGeometry& geometry, bool want_depth);

// One row for each set of parameters that the oracles depend on.
[[nodiscard]] std::vector<GeometryRow> geometryRows(const CellRun& cell, const std::string& scene);

}  // namespace ssrkit
