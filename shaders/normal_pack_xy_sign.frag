// Packs the view-space normals as x, y in 16 bits each and the sign of z in the alpha channel.
//
// A perspective camera does see normals with z < 0, towards the image's edges and on bent surfaces: the sign is needed.
// In: normal_view. Out: normal_xy_sign, r and g x and y plus 32768, so 1 to 65535, and 0 for background; a 1 where z is
// negative.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform sampler2D normal_view;

layout(location = 0) out uvec4 normal_xy_sign;

void main() {
  vec3 normal = texelFetch(normal_view, ivec2(gl_FragCoord.xy), 0).xyz;
  bool is_background = ordered_dot(normal, normal) == 0.0;
  ivec2 code = is_background ? ivec2(SNORM16_NONE) : xy_from_normal(normal);
  normal_xy_sign = uvec4(uvec2(code - SNORM16_NONE), 0u, normal.z < 0.0 ? 1u : 0u);
}
