// Traces every reflective pixel's ray by constant steps in world space.
#version 450
#include "trace_entry.glsl"
#include "ssr_march_world.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_world(ray, view_from_world, world_from_view, trace_projection(), trace_parameters());
  }
  trace_end(hit);
}
