#include "frame/temporal_techniques.h"

#include "frame/point_set.h"
#include "frame/shared_passes.h"

namespace ssrkit {

namespace {

constexpr double kDisocclusion =
    0.02;  // of the distance: a surface farther off its predicted plane is another one

FramePass accumulate(int is_straight_alpha, double max_history_length) {
  return {.name = "accumulate",
          .outputs = {"accumulated", "history_length"},
          .constants = {{"disocclusion_rel", kDisocclusion},
                        {"is_straight_alpha", is_straight_alpha},
                        {"max_history_length", max_history_length}}};
}

FramePass compositeOf(const std::string& shader_name) {
  return {.name = shader_name, .outputs = {"composite"}, .inputs = {{"reflection", "accumulated"}}};
}

const std::vector<std::string> kReadBack = {"reflection", "accumulated", "history_length", "composite"};

Technique history() {
  return {.name = "history",
          .about = "what each ray hit as the previous frame showed it, found by the hit's own motion",
          .after_trace = {{.name = "resolve_history",
                           .outputs = {"reflection"},
                           .constants = {{"disocclusion_rel", kDisocclusion}}},
                          {.name = "composite", .outputs = {"composite"}}},
          .frame_count = 2};
}

Technique temporal() {
  return {.name = "temporal",
          .about = "reflections of several frames together, found by the mirrored hit's motion",
          .after_trace = {resolvePass(), accumulate(1, 9.0), compositeOf("composite")},
          .frame_count = 8,
          .read_back = kReadBack};
}

// One microfacet a pixel and frame, another one in each frame.
Technique temporalGgx() {
  return {.name = "ggx_temporal",
          .about = "GGX: one visible microfacet a pixel and frame, 16 frames together",
          .frame = "basic",
          .before_trace = {{.name = "sample_microfacet",
                            .outputs = {"microfacet_normal"},
                            .constants = {{"point_set", kBlueHammersley}}}},
          .trace_inputs = {{"normal_view", "microfacet_normal"}},
          .after_sample = {{.name = "accumulate_microfacet",
                            .outputs = {"reflected_sum_next"},
                            .swaps_with = {"reflected_sum"}}},
          .after_trace = {{.name = "average_samples", .outputs = {"reflection"}},
                          accumulate(0, 15.0),
                          compositeOf("composite_reflected")},
          .frame_count = 16,
          .read_back = kReadBack};
}

// Weighed by confidence before they are averaged: what fades is what each frame knew.
Technique replacingTemporal() {
  FramePass averaged = accumulate(1, 9.0);
  averaged.inputs = {{"reflection", "reflection_weighed"}};
  return {.name = "replace_temporal",
          .about = "confident reflections of several frames together, in the place of the environment's",
          .frame = "full",
          .after_trace = {resolvePass(), confidencePass(), averaged, compositeOf("composite_replace")},
          .frame_count = 8,
          .read_back = {"reflection", "reflection_weighed", "accumulated", "history_length", "composite"}};
}

// Without Fresnel and the sky, for the frame's sum to weigh: the hits' radiance with their share as its
// alpha.
Technique replacingTemporalGgx() {
  Technique technique = temporalGgx();
  technique.name = "replace_ggx_temporal";
  technique.about += ", in the place of the environment's";
  technique.frame = "full";
  technique.after_sample = {accumulateArrivingPass()};
  technique.after_trace = {{.name = "average_arriving", .outputs = {"reflection"}},
                           accumulate(1, 15.0),
                           compositeOf("composite_replace")};
  return technique;
}

}  // namespace

std::vector<Technique> temporalTechniques() {
  return {history(), temporal(), temporalGgx(), replacingTemporal(), replacingTemporalGgx()};
}

}  // namespace ssrkit
