// Mutant of normal_unpack_xy_sign.frag: see normal_sign_lost.toml.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform usampler2D normal_xy_sign;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out vec4 normal_unpacked;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  uvec4 stored = texelFetch(normal_xy_sign, texel, 0);
  ivec2 code = ivec2(stored.xy) + SNORM16_NONE;
  vec3 normal = code.x == SNORM16_NONE ? vec3(0.0) : normal_from_xy_sign(code, false);
  normal_unpacked = vec4(normal, texelFetch(normal_view, texel, 0).a);
}
