// Linear depth from the stored one: what a tracer reads when the G-buffer keeps no dist_view of its own.
//
// In: depth_window. Out: dist_unpacked, metres, +inf for background: a depth of 1 is what the clear left.
#version 450
#include "ssr_spaces.glsl"

layout(std140, binding = 0) uniform DistBlock { mat4 clip_from_view; };

layout(binding = 1) uniform sampler2D depth_window;

layout(location = 0) out float dist_unpacked;

void main() {
  float depth = texelFetch(depth_window, ivec2(gl_FragCoord.xy), 0).x;
  bool is_background = depth >= 1.0;
  float dist = dist_view_from_depth_window(is_background ? 0.0 : depth, clip_from_view);
  dist_unpacked = is_background ? uintBitsToFloat(0x7f800000u) : dist;
}
