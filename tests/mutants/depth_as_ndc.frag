// Mutant of dist_from_window.frag: see depth_as_ndc.toml.
#version 450

layout(std140, binding = 0) uniform DistBlock { mat4 clip_from_view; };

layout(binding = 1) uniform sampler2D depth_window;

layout(location = 0) out float dist_unpacked;

void main() {
  float depth = texelFetch(depth_window, ivec2(gl_FragCoord.xy), 0).x;
  bool is_background = depth >= 1.0;
  // The same projection as OpenGL's own matrix has it, z from -1 to 1.
  float ndc_22 = 2.0 * clip_from_view[2][2] + 1.0;
  float ndc_32 = 2.0 * clip_from_view[3][2];
  float dist = ndc_32 / ((is_background ? 0.0 : depth) + ndc_22);
  dist_unpacked = is_background ? uintBitsToFloat(0x7f800000u) : dist;
}
