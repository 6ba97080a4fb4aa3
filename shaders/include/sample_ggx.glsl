// Samples the GGX distribution of visible normals: the microfacet normals that the eye sees.
//
// Reflecting the viewing direction at such a normal draws directions for which the estimator of reflected radiance,
// brdf * cosine / density, is Fresnel * G2 / G1, which lies in 0..1.
// Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4) 2018, section 3: stretch the view by alpha,
// sample the visible hemisphere of the unit sphere, stretch back. The hemisphere by Dupuy and Benyoub, "Sampling
// Visible GGX Normals with Spherical Caps", CGF 42(8) 2023: a point of the cap about the view, added to the view, is
// the half vector. Nothing here leaves a driver a choice (ssr_ordered.glsl, unit_circle), so every device traces the
// same rays.
#ifndef SAMPLE_GGX_GLSL
#define SAMPLE_GGX_GLSL

#include "ssr_ordered.glsl"

const float TWO_PI = 6.28318530717959;

// Cosine and sine of a fraction of a turn, 0..1. Taylor series about the nearest quarter, within 3e-7: drivers' own sin
// and cos differ in the last places.
vec2 unit_circle(float turn) {
  float quarter = floor(4.0 * turn + 0.5);
  float angle = TWO_PI * (turn - 0.25 * quarter);
  float x = angle * angle;
  float cosine = 1.0 + x * (-1.0 / 2.0 + x * (1.0 / 24.0 + x * (-1.0 / 720.0 + x * (1.0 / 40320.0))));
  float sine = angle * (1.0 + x * (-1.0 / 6.0 + x * (1.0 / 120.0 + x * (-1.0 / 5040.0 + x * (1.0 / 362880.0)))));
  int turns = int(quarter) & 3;
  vec2 turned = (turns & 1) == 0 ? vec2(cosine, sine) : vec2(-sine, cosine);
  return turns < 2 ? turned : -turned;
}

// A right-handed frame with z along the unit normal (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1)
// 2017). Columns: tangent, bitangent, normal.
mat3 frame_about(vec3 normal) {
  float side = normal.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + normal.z);
  float b = normal.x * normal.y * a;
  return mat3(vec3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x),
              vec3(b, side + normal.y * normal.y * a, -normal.y), normal);
}

vec3 to_frame(mat3 frame, vec3 v) {
  return vec3(ordered_dot(frame[0], v), ordered_dot(frame[1], v), ordered_dot(frame[2], v));
}

vec3 from_frame(mat3 frame, vec3 v) { return (v.x * frame[0] + v.y * frame[1]) + v.z * frame[2]; }

// to_eye is a unit vector in the frame of the normal (z), above the surface; point in the unit square. Unit normal.
vec3 sample_visible_normal(vec3 to_eye, float alpha, vec2 point) {
  vec3 stretched = ordered_normalize(vec3(alpha * to_eye.xy, to_eye.z));
  // The cap reaches from the view's own pole down to the plane that the view sees edge-on.
  float z = (1.0 - point.y) * (1.0 + stretched.z) - stretched.z;
  vec2 on_circle = unit_circle(point.x) * sqrt(max(1.0 - z * z, 0.0));
  vec3 half_vector = vec3(on_circle, z) + stretched;
  return ordered_normalize(vec3(alpha * half_vector.xy, half_vector.z));
}

// D, per steradian. With the sine in the place of 1 - cosine^2, which cancels to nothing at small alpha.
float distribution_in_frame(vec3 half_vector, float alpha) {
  float alpha_2 = alpha * alpha;
  float spread = alpha_2 * half_vector.z * half_vector.z + ordered_dot(half_vector.xy, half_vector.xy);
  return 2.0 * alpha_2 / (TWO_PI * spread * spread);
}

// Hidden area over visible area of the microsurface, seen along a direction above it (Heitz, "Understanding the
// Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2) 2014, equation 72).
float smith_lambda(vec3 direction, float alpha) {
  float tangent_2 = ordered_dot(direction.xy, direction.xy) / (direction.z * direction.z);
  return 0.5 * (sqrt(1.0 + alpha * alpha * tangent_2) - 1.0);
}

// G2 / G1 of the eye, masking and shadowing correlated by height (the same, equation 99): the share of what a visible
// microfacet reflects that gets out.
float unshadowed_share(vec3 to_eye, vec3 to_light, float alpha) {
  float visible = 1.0 + smith_lambda(to_eye, alpha);
  return visible / (visible + smith_lambda(to_light, alpha));
}

#endif
