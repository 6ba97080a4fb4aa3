// Packs the view-space normals octahedrally into two signed 16-bit channels: 4 bytes a texel instead of 16.
//
// In: normal_view. Out: normal_octahedral; SNORM16_NONE twice where there is no normal: background.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform sampler2D normal_view;

layout(location = 0) out ivec2 normal_octahedral;

void main() {
  vec3 normal = texelFetch(normal_view, ivec2(gl_FragCoord.xy), 0).xyz;
  bool is_background = ordered_dot(normal, normal) == 0.0;
  // Any unit vector keeps the division away from 0 / 0.
  ivec2 code = octahedral_from_normal(is_background ? vec3(0.0, 0.0, 1.0) : normal);
  normal_octahedral = is_background ? ivec2(SNORM16_NONE) : code;
}
