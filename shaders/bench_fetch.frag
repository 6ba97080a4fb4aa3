// A roofline: reads of the depth image that wait for nothing.
//
// In:  dist_view. Out: roofline, the texels read.
#version 450

layout(std140, binding = 0) uniform RooflineBlock {
  vec2 size_px;
  vec2 texel_uv;
  int roofline_count;
};

layout(binding = 1) uniform sampler2D dist_view;

layout(location = 0) out float roofline;

// As the tracers read it.
float load_dist_view(vec2 texel) { return textureLod(dist_view, (texel + 0.5) * texel_uv, 0.0).x; }

#include "roofline_fetch.glsl"

void main() { roofline = roofline_independent_fetches(floor(gl_FragCoord.xy), size_px.x, roofline_count); }
