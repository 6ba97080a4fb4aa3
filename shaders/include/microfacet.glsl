// A pixel's sampled microfacet, as the tracers read it, and what the ray reflected at it weighs.
//
// microfacet_normal stands in the place of normal_view and has its layout: xyz unit normal; a clearance, the cosine
// between the reflected viewing direction and the geometric normal. Reflection at a microfacet is reflection at its
// normal, so tracers, oracle and contract stay as they are.
#ifndef MICROFACET_GLSL
#define MICROFACET_GLSL

#include "fresnel.glsl"
#include "sample_ggx.glsl"

// Below this roughness a surface is a mirror: one exact ray, the bits of the plain technique.
const float MIRROR_ROUGHNESS = 1e-3;

bool is_mirror(float roughness) { return roughness < MIRROR_ROUGHNESS; }

float ggx_alpha(float roughness) { return roughness * roughness; }

// The clearance of the ray that leaves along `reflected`. The G-buffer knows the geometric normal only through the
// mirror direction's cosine to it; to first order the cosine changes as that to the shading normal does, exactly so
// where no normal map parts the two. A ray below the shading normal is below the surface too.
float microfacet_clearance(vec4 normal_and_clearance, vec3 normal, vec3 from_eye, vec3 reflected) {
  vec3 turned_by = reflected - ordered_reflect(from_eye, normal);
  return min(normal_and_clearance.a + ordered_dot(turned_by, normal), ordered_dot(reflected, normal));
}

// normal_and_clearance is the texel of normal_view; from_eye the unit viewing direction.
vec4 microfacet_of(vec4 normal_and_clearance, vec3 from_eye, float roughness, vec2 point) {
  vec3 normal = ordered_normalize(normal_and_clearance.xyz);
  mat3 frame = frame_about(normal);
  vec3 to_eye = to_frame(frame, -from_eye);
  if (is_mirror(roughness) || to_eye.z <= 0.0) {
    return normal_and_clearance;  // seen from behind there is no visible microfacet: the tracers refuse the ray
  }
  vec3 microfacet = from_frame(frame, sample_visible_normal(to_eye, ggx_alpha(roughness), point));
  vec3 reflected = ordered_reflect(from_eye, microfacet);
  return vec4(microfacet, microfacet_clearance(normal_and_clearance, normal, from_eye, reflected));
}

// brdf * cosine / density of the sampled direction: Fresnel * G2 / G1 (Heitz 2018, equation 19). A direction that the
// microfacet sends below the surface carries nothing: single scattering loses it.
vec3 microfacet_weight(vec3 normal, vec3 microfacet, vec3 from_eye, float roughness, vec3 f0) {
  float cosine = clamp(-ordered_dot(from_eye, microfacet), 0.0, 1.0);
  vec3 fresnel = fresnel_schlick(f0, cosine);
  if (is_mirror(roughness)) {
    return fresnel;
  }
  mat3 frame = frame_about(normal);
  vec3 to_eye = to_frame(frame, -from_eye);
  vec3 to_light = to_frame(frame, ordered_reflect(from_eye, microfacet));
  if (to_light.z <= 0.0 || to_eye.z <= 0.0) {
    return vec3(0.0);
  }
  return fresnel * unshadowed_share(to_eye, to_light, ggx_alpha(roughness));
}

#endif
