// Traces every reflective pixel's ray through the min-depth pyramid, textbook form: one mip level a pyramid level.
#version 450
#include "trace_entry.glsl"

layout(binding = 4) uniform sampler2D pyramid;

vec2 load_pyramid(vec2 cell, int mip) { return texelFetch(pyramid, ivec2(cell), mip).xy; }

#include "ssr_march_hiz.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_hiz(ray, trace_parameters());
  }
  trace_end(hit);
}
