// Traces every reflective pixel's ray by the screen-space DDA.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_dda.glsl"
#include "ssr_march_strided.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    TraceParameters parameters = trace_parameters();
    hit = parameters.stride_px > 1.0 ? march_dda_strided(ray, parameters) : march_dda(ray, parameters);
  }
  trace_end(hit);
}
