#include "frame/roofline_techniques.h"

#include "frame/shared_passes.h"
#include "spaces/roofline.h"

namespace ssrkit {

std::vector<Technique> rooflineTechniques() {
  return {{.name = "rooflines",
           .about = "mirror, and before each trace passes that read, compute or write and do nothing else",
           .before_trace = {{.name = "bench_dependent_fetch",
                             .outputs = {"roofline_dependent_fetch"},
                             .constants = {{"roofline_count", kRooflineFetchCount}}},
                            {.name = "bench_fetch",
                             .outputs = {"roofline_fetch"},
                             .constants = {{"roofline_count", kRooflineFetchCount}}},
                            {.name = "bench_alu",
                             .outputs = {"roofline_alu"},
                             .constants = {{"roofline_count", kRooflineAluCount},
                                           {"roofline_scale", 1.0},
                                           {"roofline_add", 0.25}}},
                            // The tracer writes over it.
                            {.name = "bench_write", .outputs = {"hit_texel", "hit_point", "ray_work"}}},
           .after_trace = {resolvePass(), {.name = "composite", .outputs = {"composite"}}},
           .read_back = {"reflection", "composite", "roofline_dependent_fetch", "roofline_fetch",
                         "roofline_alu"}}};
}

}  // namespace ssrkit
