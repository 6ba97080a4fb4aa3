// Traces every reflective pixel's ray by the screen-space DDA.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_dda.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_dda(ray, trace_parameters());
  }
  trace_end(hit);
}
