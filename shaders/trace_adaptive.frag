// Traces every reflective pixel's ray by steps that follow the depth difference, and binary refinement.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_adaptive.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_adaptive(ray, trace_projection(), trace_parameters());
  }
  trace_end(hit);
}
