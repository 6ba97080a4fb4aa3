#include "frame/trace_pass.h"

#include <algorithm>

#include "frame/stages.h"

namespace ssrkit {

FramePass tracePass(const std::string& shader) {
  return {.name = shader.substr(0, shader.find('.')),
          .outputs = {"hit_texel", "hit_point", "ray_work"},
          .shader = shader,
          .depth = "ray_depth",
          .layer = 1,
          .clears = {"hit_texel", "hit_point"}};
}

const FramePass& withoutRayPass() {
  static const FramePass pass{.name = "without_ray",
                              .outputs = {"ray_work"},
                              .depth = "ray_depth",
                              .layer = 1,
                              .clears = {"ray_depth"}};
  return pass;
}

std::string recordSuffix(const Technique& technique) {
  return technique.ray_stride_texels > 1 ? "_half" : "";
}

std::vector<FramePass> tracePasses(const std::string& shader, const Technique& technique) {
  std::vector<FramePass> passes = {withoutRayPass(), tracePass(shader)};
  for (FramePass& pass : passes) {
    pass.inputs = technique.trace_inputs;
    for (std::vector<std::string>* names : {&pass.outputs, &pass.clears}) {
      std::ranges::for_each(*names, [&](std::string& name) { name += recordSuffix(technique); });
    }
    pass.depth += recordSuffix(technique);
  }
  return passes;
}

void drawWhereRaysStart(Technique& technique) {
  int layer = withoutRayPass().layer;
  for (FramePass& pass : technique.after_trace) {
    if (pass.where_rays_start) {
      pass.depth = "ray_depth" + recordSuffix(technique);
      pass.layer = ++layer;
    }
  }
}

void setTraceUniforms(UniformValues& values, const TraceParameters& parameters) {
  values.set("thickness_m", parameters.thickness_m);
  values.set("thickness_rel", parameters.thickness_rel);
  values.set("max_distance_m", parameters.max_distance_m);
  values.set("origin_bias", parameters.origin_bias);
  values.set("step_m", parameters.step_m);
  values.set("stride_px", static_cast<double>(parameters.stride_px));
  values.set("jitter", parameters.jitter);
  values.set("lookup_budget", parameters.lookup_budget);
  values.set("step_count", parameters.step_count);
  values.set("bisection_count", parameters.bisection_count);
  values.set("max_mip", parameters.max_mip);
  values.set("step_growth", parameters.step_growth);
  values.set("first_step_share", firstStepShare(parameters.step_growth, parameters.step_count));
  values.set("ray_stride_texels", 1);
}

}  // namespace ssrkit
