// The metallic-roughness surface: GGX's microfacets over a Lambertian base.
//
// All cosines are between unit vectors and must be over 0; so must alpha = roughness^2, and below some 0.01 single
// precision runs out. Nothing here is defined for light or viewer below the horizon: callers leave those out.
//   Walter, Marschner, Li, Torrance, "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 33
//   Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2) 2014, eq. 99
//   Turquin, "Practical multiple scattering compensation for microfacet models", 2019, section 3
#ifndef BRDF_GGX_GLSL
#define BRDF_GGX_GLSL
#include "fresnel.glsl"
#include "ssr_ordered.glsl"

const float BRDF_PI = 3.14159265358979;

struct GgxSurface {
  vec3 normal;
  vec3 to_eye;
  float cos_view;
  float alpha;
  vec3 f0;       // reflectance at normal incidence ...
  float f90;     // ... and at grazing incidence
  vec3 diffuse;  // albedo of the base
};

// D: how much of the surface faces the half vector, per solid angle. Its projection on the surface integrates to 1.
float ggx_distribution(float cos_half, float alpha) {
  float alpha2 = alpha * alpha;
  float shape = (alpha2 - 1.0) * cos_half * cos_half + 1.0;
  return alpha2 / (BRDF_PI * shape * shape);
}

// G2 / (4 cos_light cos_view), masking and shadowing correlated by height.
float smith_visibility(float cos_light, float cos_view, float alpha) {
  float alpha2 = alpha * alpha;
  float view_term = cos_light * sqrt(cos_view * cos_view * (1.0 - alpha2) + alpha2);
  float light_term = cos_view * sqrt(cos_light * cos_light * (1.0 - alpha2) + alpha2);
  return 0.5 / (view_term + light_term);
}

// Nothing real reflects less than 2 % at normal incidence: less stands for a surface without an interface, whose
// grazing reflection fades out too, down to none on black (Lagarde and de Rousiers, "Moving Frostbite to Physically
// Based Rendering", SIGGRAPH 2014 course, section 3.2).
float fresnel_f90(vec3 f0) { return min(50.0 * max(max(f0.r, f0.g), f0.b), 1.0); }

// Single scattering loses 1 - (scale + bias) of a white environment, 69 % at most; light that leaves a microfacet to
// meet another comes back as more of the same lobe, so that F0 = 1 reflects all.
vec3 multiple_scattering(vec3 f0, vec2 scale_bias) { return 1.0 + f0 * (1.0 / (scale_bias.x + scale_bias.y) - 1.0); }

// What the surface reflects of a white environment, by the split sum's scale and bias (environment.glsl). Never over 1.
vec3 specular_albedo(vec3 f0, vec2 scale_bias) {
  return (f0 * scale_bias.x + fresnel_f90(f0) * scale_bias.y) * multiple_scattering(f0, scale_bias);
}

// Reflected radiance over irradiance, for light from one direction. The base gets what the lobe leaves.
vec3 ggx_brdf(GgxSurface surface, vec3 to_light, float cos_light, vec2 scale_bias) {
  vec3 sum = to_light + surface.to_eye;
  vec3 half_vector = sum / sqrt(max(ordered_dot(sum, sum), 1e-12));  // light from right behind the surface has none
  float cos_half = clamp(ordered_dot(surface.normal, half_vector), 0.0, 1.0);
  float cos_view_half = clamp(ordered_dot(surface.to_eye, half_vector), 0.0, 1.0);
  float lobe = ggx_distribution(cos_half, surface.alpha) * smith_visibility(cos_light, surface.cos_view, surface.alpha);
  vec3 fresnel = surface.f0 + (surface.f90 - surface.f0) * schlick_rise(cos_view_half);
  vec3 left_over = 1.0 - specular_albedo(surface.f0, scale_bias);
  return surface.diffuse * left_over / BRDF_PI + fresnel * multiple_scattering(surface.f0, scale_bias) * lobe;
}

#endif
