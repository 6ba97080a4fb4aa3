// Traces every reflective pixel's ray by a coarse march and binary refinement.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_refined.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_refined(ray, trace_projection(), trace_parameters());
  }
  trace_end(hit);
}
