// Traces every reflective pixel's ray by the exact walk over every cell it crosses.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_walk.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_walk(ray, trace_parameters());
  }
  trace_end(hit);
}
