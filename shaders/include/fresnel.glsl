// Fresnel reflectance after Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Eurographics 1994.
//
// In:  f0, reflectance at normal incidence, 0..1; cosine of the angle between normal and view direction, 0..1.
// Out: f0 at cosine 1, 1 at cosine 0, monotone between. How far it is from the exact equations: docs/techniques.md.
#ifndef FRESNEL_GLSL
#define FRESNEL_GLSL

const float DIELECTRIC_F0 = 0.04;  // a refractive index of 1.5, as glTF 2.0 has it

// Products, not pow(): pow(0.0, 5.0) is exact on few drivers, and grazing rays are the ones that matter here.
float schlick_rise(float cosine) {
  float complement = 1.0 - cosine;
  float squared = complement * complement;
  return squared * squared * complement;
}

vec3 fresnel_schlick(vec3 f0, float cosine) { return f0 + (1.0 - f0) * schlick_rise(cosine); }

// A metal reflects in its own colour, everything else without colour (glTF 2.0, appendix B).
vec3 fresnel_f0(vec3 base_colour, float metallic) { return mix(vec3(DIELECTRIC_F0), base_colour, metallic); }

#endif
