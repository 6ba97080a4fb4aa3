// Linear depth from the stored one: what a tracer reads when the G-buffer keeps no dist_view of its own.
//
// The rasteriser stores depth_window = P23 / dist_view - P22 of the projection P (docs/spaces.md), 0 at the near plane
// and 1 at the far plane on every API, so dist_view = P23 / (depth_window + P22). An inverse of OpenGL's matrix with
// its -1..1 range needs 2 * depth_window - 1 instead. A depth of 1 is what the clear left: background.
// In: depth_window. Out: dist_unpacked, metres, +inf for background.
#version 450

layout(std140, binding = 0) uniform DistBlock { mat4 clip_from_view; };

layout(binding = 1) uniform sampler2D depth_window;

layout(location = 0) out float dist_unpacked;

void main() {
  float depth = texelFetch(depth_window, ivec2(gl_FragCoord.xy), 0).x;
  bool is_background = depth >= 1.0;
  float dist = clip_from_view[3][2] / ((is_background ? 0.0 : depth) + clip_from_view[2][2]);
  dist_unpacked = is_background ? uintBitsToFloat(0x7f800000u) : dist;
}
