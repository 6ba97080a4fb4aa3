// Unit normals in two 16-bit channels: what a packed G-buffer stores, and what comes back.
//
// Octahedral: the sphere is projected onto the octahedron |x| + |y| + |z| = 1 and its lower half folded over the upper
//   (Meyer et al., "On Floating-Point Normal Vectors", EGSR 2010; Cigolle et al., "A Survey of Efficient
//   Representations for Independent Unit Vectors", JCGT 3(2) 2014, section 3). Even over the sphere: the largest error
//   at 2 x 16 bits is 0.0037 degrees.
// xy and sign: x and y as they are, z from the unit length, its sign in a bit of its own. Exact at the pole, but z is
//   the root of a small difference near z = 0: there the largest error is 0.38 degrees (docs/techniques.md).
//
// In: unit vectors. Out: integers in -32767..32767, and back. Rounding is to the nearest, half upwards, written out so
// that every device stores the same integers. Zero of either sign counts as positive; a stored xy outside the unit
// circle, as rounding makes it, has z = 0. What is read is normalised, so that it is a unit vector again.
#ifndef NORMAL_ENCODING_GLSL
#define NORMAL_ENCODING_GLSL

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
  return ordered_normalize(vec3(unfolded, z));
}

ivec2 xy_from_normal(vec3 normal) { return snorm16_from_float(vec2(normal.x, normal.y)); }

vec3 normal_from_xy_sign(ivec2 stored, bool is_negative) {
  vec2 xy = float_from_snorm16(stored);
  float z = sqrt(max(1.0 - ordered_dot(xy, xy), 0.0));
  return ordered_normalize(vec3(xy, is_negative ? -z : z));
}

#endif
