#include "frame/stages.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/check.h"
#include "frame/find_row.h"

namespace ssrkit {

namespace {

const std::vector<Stage>& stageTable() {
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
      {.name = "naive_32",
       .about = "naive, 32 steps",
       .shader = "trace_naive.frag",
       .tuned_shader = "trace_naive.frag",
       .preset = {{"step_count", "32"}}},
      {.name = "naive_128",
       .about = "naive, 128 steps",
       .shader = "trace_naive.frag",
       .tuned_shader = "trace_naive.frag",
       .preset = {{"step_count", "128"}}},
      {.name = "world",
       .about = "constant steps in world space",
       .shader = "trace_world.frag",
       .tuned_shader = "trace_world.frag",
       .default_step_count = 256},
      {.name = "world_32",
       .about = "world, 32 steps",
       .shader = "trace_world.frag",
       .tuned_shader = "trace_world.frag",
       .preset = {{"step_count", "32"}}},
      {.name = "world_128",
       .about = "world, 128 steps",
       .shader = "trace_world.frag",
       .tuned_shader = "trace_world.frag",
       .preset = {{"step_count", "128"}}},
      {.name = "exponential",
       .about = "steps that grow along the 3-D ray, with binary refinement",
       .shader = "trace_exponential.frag",
       .tuned_shader = "trace_exponential.frag",
       .default_step_count = 64,
       .default_bisections = 8,
       .preset = {{"step_growth", "1.05"}}},
      {.name = "adaptive",
       .about = "steps that follow the depth difference, with binary refinement",
       .shader = "trace_adaptive.frag",
       .tuned_shader = "trace_adaptive.frag",
       .default_step_count = 256,
       .default_bisections = 8,
       .preset = {{"step_growth", "1.1"}}},
      {.name = "homogeneous",
       .about = "steps of an exact number of pixels in clip space",
       .shader = "trace_homogeneous.frag",
       .tuned_shader = "trace_homogeneous.frag",
       .default_bisections = 8,
       .preset = {{"stride_px", "4"}}},
      {.name = "capped",
       .about = "screen-space march with a most number of samples",
       .shader = "trace_capped.frag",
       .tuned_shader = "trace_capped.frag",
       .default_step_count = 64,
       .default_bisections = 5,
       .preset = {{"stride_px", "2"}}},
      {.name = "dda_8_0",
       .about = "dda, stride 8",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .preset = {{"stride_px", "8"}, {"bisection_count", "0"}}},
      {.name = "dda_8_4",
       .about = "dda, stride 8, 4 bisections",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .preset = {{"stride_px", "8"}, {"bisection_count", "4"}}},
      {.name = "dda_8_4_dither",
       .about = "dda, stride 8, 4 bisections, dithered",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .preset = {{"stride_px", "8"}, {"bisection_count", "4"}, {"jitter", "1"}}},
      {.name = "dda_32_0",
       .about = "dda, stride 32",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .preset = {{"stride_px", "32"}, {"bisection_count", "0"}}},
      {.name = "dda_32_4",
       .about = "dda, stride 32, 4 bisections",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .preset = {{"stride_px", "32"}, {"bisection_count", "4"}}},
      {.name = "dda_32_4_dither",
       .about = "dda, stride 32, 4 bisections, dithered",
       .shader = "trace_dda.frag",
       .tuned_shader = "trace_dda.frag",
       .preset = {{"stride_px", "32"}, {"bisection_count", "4"}, {"jitter", "1"}}},
      {.name = "walk",
       .about = "every cell that the ray crosses: the yardstick",
       .shader = "trace_walk.frag",
       .tuned_shader = "trace_walk.frag"},
  };
  return rows;
}

}  // namespace

std::span<const Stage> stages() {
  return stageTable();
}

Expected<const Stage*> findStage(std::string_view name) {
  return findRow(stages(), name, "stage");
}

TraceParameters askedParameters(const TraceParameters& scene, const Stage& stage,
                                const ParameterList& chosen) {
  TraceParameters parameters = scene;
  for (const ParameterList* list : {&stage.preset, &chosen}) {
    for (const auto& [name, value] : *list) {
      SSRKIT_CHECK(setParameter(parameters, name, value, stage.name).has_value());
    }
  }
  return parameters;
}

double firstStepShare(double growth, int step_count) {
  // Far below any share that can be told from nothing in single precision, and still no step of length zero.
  constexpr double kLeastShare = 1e-9;
  const double count = std::max(step_count, 1);
  const double share = growth > 1.0 ? (growth - 1.0) / std::expm1(count * std::log(growth)) : 1.0 / count;
  return std::max(share, kLeastShare);
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
