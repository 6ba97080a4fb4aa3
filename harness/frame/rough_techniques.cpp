#include "frame/rough_techniques.h"

#include <fmt/format.h>

#include "frame/point_set.h"
#include "frame/shared_passes.h"

namespace ssrkit {

namespace {

// One sampled microfacet a ray, weighed by the microfacet model.
Technique ggx(const std::string& name, int sample_count, int point_set) {
  return {.name = name,
          .about = fmt::format("GGX: {} visible microfacet{} a pixel, from {} points", sample_count,
                               sample_count == 1 ? "" : "s",
                               point_set == kWhitePoints ? "independent" : "blue Hammersley"),
          .frame = "basic",
          .before_trace = {{.name = "sample_microfacet",
                            .outputs = {"microfacet_normal"},
                            .constants = {{"point_set", point_set}}}},
          .trace_inputs = {{"normal_view", "microfacet_normal"}},
          .sample_count = sample_count,
          .after_sample = {{.name = "accumulate_microfacet",
                            .outputs = {"reflected_sum_next"},
                            .swaps_with = {"reflected_sum"}}},
          .after_trace = {{.name = "average_samples", .outputs = {"reflection"}},
                          {.name = "composite_reflected", .outputs = {"composite"}}}};
}

// The normal moved about at random: no microfacet model, so the plain composite's Fresnel weighs the mean.
Technique jittered(const std::string& name, int sample_count) {
  return {.name = name,
          .about = fmt::format("normals jittered by roughness, {} ray{} a pixel", sample_count,
                               sample_count == 1 ? "" : "s"),
          .before_trace = {{.name = "jitter_normal",
                            .outputs = {"microfacet_normal"},
                            .constants = {{"point_set", kBlueHammersley}}}},
          .trace_inputs = {{"normal_view", "microfacet_normal"}},
          .sample_count = sample_count,
          .after_sample = {{.name = "accumulate_hits",
                            .outputs = {"reflected_sum_next"},
                            .swaps_with = {"reflected_sum"}}},
          .after_trace = {{.name = "average_hits", .outputs = {"reflection"}},
                          {.name = "composite", .outputs = {"composite"}}}};
}

// Beyond it one ray and eight neighbours say nothing that the sky does not.
constexpr double kMaxTracedRoughness = 0.6;

FramePass filter(const std::string& name, int spacing_px, const std::string& from, const std::string& to) {
  return {.name = name,
          .outputs = {"reflection" + to, to.empty() ? "reflection_variance" : "variance" + to},
          .inputs = {{"unfiltered", "reflection" + from}, {"unfiltered_variance", "variance" + from}},
          .constants = {{"spacing_px", spacing_px}},
          .shader = "filter_reflection.frag"};
}

// What rays met, without Fresnel and without the sky, for the frame's metallic-roughness sum: there the
// environment fills what the hits leave, and the split sum weighs both.
Technique replacingGgx(int sample_count) {
  Technique technique = ggx(fmt::format("replace_ggx_{}", sample_count), sample_count, kBlueHammersley);
  technique.about += ", in the place of the environment's";
  technique.frame = "full";
  technique.after_sample = {accumulateArrivingPass()};
  technique.after_trace = {{.name = "average_arriving", .outputs = {"reflection"}},
                           {.name = "composite_replace", .outputs = {"composite"}}};
  return technique;
}

// Stochastic SSR: one ray a pixel, what it found shared among neighbours, what noise is left filtered.
Technique stochastic() {
  return {.name = "stochastic",
          .about = "stochastic SSR: one ray a pixel, reused by its neighbours, filtered by its variance",
          .frame = "basic",
          .before_trace = {{.name = "classify_rays",
                            .outputs = {"microfacet_normal", "ray_material"},
                            .constants = {{"max_traced_roughness", kMaxTracedRoughness}}}},
          .trace_inputs = {{"normal_view", "microfacet_normal"}, {"material", "ray_material"}},
          .after_trace = {{.name = "ray_ends", .outputs = {"ray_end", "ray_radiance", "ray_density"}},
                          {.name = "reuse_rays",
                           .outputs = {"reflection_reused", "variance_reused"},
                           .constants = {{"hits_only", 0}}},
                          filter("filter_1", 1, "_reused", "_near"),
                          filter("filter_2", 2, "_near", "_reused"),
                          filter("filter_4", 4, "_reused", ""),
                          {.name = "composite_reflected", .outputs = {"composite"}}}};
}

Technique replacingStochastic() {
  Technique technique = stochastic();
  technique.name = "replace_stochastic";
  technique.about += ", in the place of the environment's";
  technique.frame = "full";
  technique.after_trace[1].constants = {{"hits_only", 1}};
  technique.after_trace.back() = {.name = "unpremultiply", .outputs = {"reflection_near"}};
  technique.after_trace.push_back(
      {.name = "composite_replace", .outputs = {"composite"}, .inputs = {{"reflection", "reflection_near"}}});
  return technique;
}

}  // namespace

std::vector<Technique> roughTechniques() {
  return {jittered("jittered_1", 1),
          jittered("jittered_16", 16),
          ggx("ggx_1", 1, kBlueHammersley),
          ggx("ggx_4", 4, kBlueHammersley),
          ggx("ggx_16", 16, kBlueHammersley),
          ggx("ggx_128", 128, kBlueHammersley),
          ggx("ggx_16_white", 16, kWhitePoints),
          stochastic(),
          replacingGgx(1),
          replacingGgx(4),
          replacingGgx(16),
          replacingGgx(128),
          replacingStochastic()};
}

}  // namespace ssrkit
