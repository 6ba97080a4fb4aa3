// How public implementations put a reflection into the lit image, and what each does to the energy of a uniformly lit
// scene (a white furnace of radiance L, which should come out as L; docs/techniques.md has the table).
//
// In: linear radiance. Undefined nowhere; a miss has alpha or visibility 0 and leaves the lit image as it is, except
// in composite_mirror, which is given what arrives then instead: the sky.
#ifndef COMPOSITE_FORMS_GLSL
#define COMPOSITE_FORMS_GLSL

#include "fresnel.glsl"

// Shininess of Blinn and Phong that looks as rough as roughness of GGX: 2 / roughness^4 - 2 (Akenine-Moller et al.,
// "Real-Time Rendering", 4th ed., section 9.8.1). A perfect mirror's is infinite; the least roughness bounds it.
float shininess_of(float roughness) {
  float alpha = max(roughness, 0.15) * max(roughness, 0.15);
  return 2.0 / (alpha * alpha) - 2.0;
}

// Paula e Silva, "Implementing Screen Space Reflections on the GPU", INF584, 2020, section 3.4: how visible reflections
// are on a surface of Blinn's and Phong's model. 0 without specular, nearly `specular` from a shininess of 50 on.
float specular_visibility(float specular, float shininess) { return specular * (1.0 - exp(-shininess / 12.5)); }

// The same report, section 3.5. Adds light: a furnace comes out as L (1 + visibility).
vec3 composite_additive(vec3 lit, vec3 reflected, float visibility) { return lit + reflected * visibility; }

// KongEngine: metals reflect, everything else does not. Metallic once: weighing colour and alpha both with it and then
// multiplying them, as the engine did, squares it. A furnace comes out as L (1 + metallic).
vec3 composite_metallic(vec3 lit, vec4 reflection, float metallic) {
  return lit + reflection.rgb * (reflection.a * metallic);
}

// Adds what arrives from the mirrored direction, weighed by Fresnel, to a surface whose own share is diffuse. A furnace
// comes out as L (1 + mask F) over a surface that is lit to L itself, and as L over a perfect metal, whose own is 0.
vec3 composite_mirror(vec3 lit, vec3 arriving, vec3 fresnel, float mask) { return lit + mask * fresnel * arriving; }

// Blends towards the reflection: a furnace stays at L, for any weight.
vec3 composite_blended(vec3 lit, vec3 reflected, vec3 weight) { return mix(lit, reflected, weight); }

// 1 where the hit lies in the middle of the image, 0 on its border: the correction by the distance from the screen's
// centre that several tutorials multiply into their reflections. Smooth inside, monotone along both axes.
float centre_weight(vec2 hit_px, vec2 size_px) {
  vec2 from_centre = 2.0 * hit_px / size_px - 1.0;
  vec2 squared = from_centre * from_centre;
  vec2 weight = clamp(1.0 - squared * squared, 0.0, 1.0);
  return weight.x * weight.y;
}

#endif
