// Traces every reflective pixel's ray by steps that grow along the 3-D ray, and binary refinement.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_exponential.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_exponential(ray, trace_projection(), trace_parameters());
  }
  trace_end(hit);
}
