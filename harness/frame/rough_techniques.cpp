#include "frame/rough_techniques.h"

#include <fmt/format.h>

namespace ssrkit {

namespace {

// point_set of shaders/include/random.glsl
constexpr int kWhitePoints = 0;
constexpr int kBlueHammersley = 2;

// One sampled microfacet a ray, weighed by the microfacet model.
Technique ggx(const std::string& name, int sample_count, int point_set) {
  return {.name = name,
          .about = fmt::format("GGX: {} visible microfacet{} a pixel, from {} points", sample_count,
                               sample_count == 1 ? "" : "s",
                               point_set == kWhitePoints ? "independent" : "blue Hammersley"),
          .before_trace = {{.name = "sample_microfacet",
                            .outputs = {"microfacet_normal"},
                            .constants = {{"point_set", point_set}}}},
          .trace_inputs = {{"normal_view", "microfacet_normal"}},
          .sample_count = sample_count,
          .after_sample = {{.name = "accumulate_microfacet",
                            .outputs = {"reflected_sum_next"},
                            .swaps_with = "reflected_sum"}},
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
                            .swaps_with = "reflected_sum"}},
          .after_trace = {{.name = "average_hits", .outputs = {"reflection"}},
                          {.name = "composite", .outputs = {"composite"}}}};
}

}  // namespace

std::vector<Technique> roughTechniques() {
  return {jittered("jittered_1", 1),
          jittered("jittered_16", 16),
          ggx("ggx_1", 1, kBlueHammersley),
          ggx("ggx_4", 4, kBlueHammersley),
          ggx("ggx_16", 16, kBlueHammersley),
          ggx("ggx_128", 128, kBlueHammersley),
          ggx("ggx_16_white", 16, kWhitePoints)};
}

}  // namespace ssrkit
