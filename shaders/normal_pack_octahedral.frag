// Packs the view-space normals octahedrally into two signed 16-bit channels: 4 bytes a texel instead of 16.
//
// In: normal_view. Out: normal_octahedral. Background holds the code of whatever the clear colour is; nothing reads it.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform sampler2D normal_view;

layout(location = 0) out ivec2 normal_octahedral;

void main() {
  vec3 normal = texelFetch(normal_view, ivec2(gl_FragCoord.xy), 0).xyz;
  // Background has no normal: any unit vector keeps the division away from 0 / 0.
  bool is_background = ordered_dot(normal, normal) == 0.0;
  normal_octahedral = octahedral_from_normal(is_background ? vec3(0.0, 0.0, 1.0) : normal);
}
