// Traces every reflective pixel's ray by constant steps in view space.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_naive.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_naive(ray, trace_projection(), trace_parameters());
  }
  trace_end(hit);
}
