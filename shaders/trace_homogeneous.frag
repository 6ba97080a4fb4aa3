// Traces every reflective pixel's ray by steps of exactly stride_px pixels in homogeneous coordinates.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_homogeneous.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_homogeneous(ray, clip_from_view, trace_parameters());
  }
  trace_end(hit);
}
