// The passes that make a record, and their uniforms.
#pragma once

#include <string>
#include <vector>

#include "frame/frame_pass.h"
#include "frame/techniques.h"
#include "frame/uniform_values.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// The parameters as the tracers' uniforms; what was left open must have been filled in.
void setTraceUniforms(UniformValues& values, const TraceParameters& parameters);

// The pass of a tracer's entry file: "trace_hiz.frag" draws the pass "trace_hiz".
[[nodiscard]] FramePass tracePass(const std::string& shader);

// The pass before it: writes the class of the texels without a ray, which the tracer's shader then never
// sees.
[[nodiscard]] const FramePass& withoutRayPass();

// Both, in order, with what the technique has the tracer read and write.
[[nodiscard]] std::vector<FramePass> tracePasses(const std::string& shader, const Technique& technique);

// Gives the passes after the trace that ask for it the trace's depth, each a layer nearer than the one
// before: where no ray starts all of them fail against it.
void drawWhereRaysStart(Technique& technique);

// What is added to the names of a record's images where a technique has fewer rays than texels.
[[nodiscard]] std::string recordSuffix(const Technique& technique);

}  // namespace ssrkit
