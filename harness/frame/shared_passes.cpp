#include "frame/shared_passes.h"

namespace ssrkit {

FramePass resolvePass() {
  return {.name = "resolve", .outputs = {"reflection"}, .where_rays_start = true, .clears = {"reflection"}};
}

FramePass confidencePass() {
  // What a technique takes from the trace's own reach and budget only.
  constexpr double kNone = 1e30;
  return {.name = "confidence",
          .outputs = {"reflection_weighed"},
          .constants = {{"edge_fade_fraction", 0.1},
                        {"fade_distance_m", kNone},
                        {"rejects_back_faces", 1},
                        {"facing_fade_start", 0.75},
                        {"facing_fade_end", 1.0},
                        {"fade_lookups", kNone}},
          .where_rays_start = true,
          .clears = {"reflection_weighed"}};
}

FramePass accumulateArrivingPass() {
  return {.name = "accumulate_arriving",
          .outputs = {"reflected_sum_next", "weight_sum_next"},
          .swaps_with = {"reflected_sum", "weight_sum"}};
}

}  // namespace ssrkit
