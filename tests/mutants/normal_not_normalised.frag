// Mutant of normal_unpack_octahedral.frag: see normal_not_normalised.toml.
#version 450
#include "ssr_ordered.glsl"

const float SNORM16_MAX = 32767.0;
const int SNORM16_NONE = -32768;  // the one code that no number has: background's

ivec2 snorm16_from_float(vec2 v) { return ivec2(floor(clamp(v, vec2(-1.0), vec2(1.0)) * SNORM16_MAX + 0.5)); }

vec2 float_from_snorm16(ivec2 stored) { return vec2(stored) / SNORM16_MAX; }

// Not the built-in sign(), which is 0 at 0 and would put the whole fold's edge on the pole.
vec2 sign_not_zero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

ivec2 octahedral_from_normal(vec3 normal) {
  vec2 upper = vec2(normal.x, normal.y) / ((abs(normal.x) + abs(normal.y)) + abs(normal.z));
  vec2 folded = (vec2(1.0) - abs(vec2(upper.y, upper.x))) * sign_not_zero(upper);
  return snorm16_from_float(normal.z >= 0.0 ? upper : folded);
}

vec3 normal_from_octahedral(ivec2 stored) {
  vec2 point = float_from_snorm16(stored);
  float z = 1.0 - (abs(point.x) + abs(point.y));
  vec2 unfolded = point - sign_not_zero(point) * max(-z, 0.0);
  return vec3(unfolded, z);
}

ivec2 xy_from_normal(vec3 normal) { return snorm16_from_float(vec2(normal.x, normal.y)); }

vec3 normal_from_xy_sign(ivec2 stored, bool is_negative) {
  vec2 xy = float_from_snorm16(stored);
  float z = sqrt(max(1.0 - ordered_dot(xy, xy), 0.0));
  return ordered_normalize(vec3(xy, is_negative ? -z : z));
}

layout(binding = 1) uniform isampler2D normal_octahedral;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out vec4 normal_unpacked;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 stored = texelFetch(normal_octahedral, texel, 0).xy;
  vec3 normal = stored.x == SNORM16_NONE ? vec3(0.0) : normal_from_octahedral(stored);
  normal_unpacked = vec4(normal, texelFetch(normal_view, texel, 0).a);
}
