// A normal moved about at random in proportion to roughness: the cheapest rough reflection, and no physical one.
//
// The random vector is uniform over the sphere, so the mean direction stays the normal's. A vector with components in
// 0..1, as is easily written, lies in one octant and tilts every rough surface towards (1, 1, 1).
#ifndef JITTERED_NORMAL_GLSL
#define JITTERED_NORMAL_GLSL

#include "sample_ggx.glsl"

// Length of the random vector at roughness 1, against a normal of length 1.
const float JITTER_STRENGTH = 0.2;

// Archimedes: height and azimuth of a uniform point of the sphere are uniform.
vec3 point_on_sphere(vec2 point) {
  float z = 1.0 - 2.0 * point.y;
  return vec3(unit_circle(point.x) * sqrt(max(1.0 - z * z, 0.0)), z);
}

vec3 jittered_normal(vec3 normal, float roughness, vec2 point) {
  return ordered_normalize(normal + (JITTER_STRENGTH * roughness) * point_on_sphere(point));
}

#endif
