#include "frame/stages.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "frame/find_row.h"

namespace ssrkit {

namespace {

const std::vector<Stage>& table() {
  static const std::vector<Stage> rows = {
      {.name = "naive",
       .about = "constant steps along the 3-D ray",
       .shader = "trace_naive.frag",
       .tuned_shader = "trace_naive.frag",
       .default_step_count = 256},
      {.name = "refined",
       .about = "coarse march with binary refinement",
       .shader = "trace_refined.frag",
       .tuned_shader = "trace_refined.frag",
       .default_step_count = 64,
       .default_bisections = 8},
      {.name = "dda",
       .about = "screen-space DDA, perspective-correct",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .default_bisections = 4},
      {.name = "hiz",
       .about = "min-depth pyramid traversal",
       .shader = "trace_hiz.frag",
       .tuned_shader = "trace_hiz_tuned.frag",
       .default_max_mip = 7},
      {.name = "walk",
       .about = "every cell that the ray crosses: the yardstick",
       .shader = "trace_walk.frag",
       .tuned_shader = "trace_walk.frag"},
  };
  return rows;
}

}  // namespace

std::span<const Stage> stages() {
  return table();
}

Expected<const Stage*> findStage(std::string_view name) {
  return findRow(stages(), name, "stage");
}

TraceParameters withStageDefaults(const TraceParameters& parameters, const Stage& stage, Size size) {
  TraceParameters filled = parameters;
  if (filled.step_count == 0) {
    filled.step_count = std::max(stage.default_step_count, 1);
  }
  if (filled.bisection_count < 0) {
    filled.bisection_count = stage.default_bisections;
  }
  const auto longer_side = static_cast<unsigned>(std::max(size.width, size.height));
  const int single_cell_mip =
      static_cast<int>(std::bit_width(longer_side - 1));  // there one cell covers the image
  filled.max_mip = std::min(filled.max_mip < 0 ? stage.default_max_mip : filled.max_mip, single_cell_mip);
  return filled;
}

const std::string& shaderOf(const Stage& stage, const TraceParameters& parameters) {
  return parameters.form == TracerForm::kTuned ? stage.tuned_shader : stage.shader;
}

}  // namespace ssrkit
