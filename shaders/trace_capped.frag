// Traces every reflective pixel's ray by a screen-space march with a fixed most number of samples.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_capped.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_capped(ray, trace_parameters());
  }
  trace_end(hit);
}
