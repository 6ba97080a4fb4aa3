// Packs the view-space normals as x, y in 16 bits each and the sign of z in the alpha channel.
//
// A perspective camera does see normals with z < 0, towards the image's edges and on bent surfaces: the sign is needed.
// In: normal_view. Out: normal_xy_sign, r and g x and y from 0 (-1) to 65534 (+1), a 1 where z is negative.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform sampler2D normal_view;

layout(location = 0) out uvec4 normal_xy_sign;

void main() {
  vec3 normal = texelFetch(normal_view, ivec2(gl_FragCoord.xy), 0).xyz;
  normal_xy_sign = uvec4(uvec2(xy_from_normal(normal) + ivec2(SNORM16_MAX)), 0u, normal.z < 0.0 ? 1u : 0u);
}
