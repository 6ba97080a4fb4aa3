// The G-buffer's texel as a GGX surface, and its share of the environment.
//
// The including file provides what environment.glsl asks for. Directions are in view space but where the name says.
#ifndef SURFACE_GGX_GLSL
#define SURFACE_GGX_GLSL
#include "brdf_ggx.glsl"
#include "environment.glsl"
#include "unit_normal.glsl"

// A highlight of an infinitely small light on a sharper surface is one flickering pixel; image-based light, which has
// a size, takes the roughness as it is.
const float MIN_LIGHT_ROUGHNESS = 0.15;
const float MIN_COS_VIEW = 1e-3;  // interpolated normals may face away from the viewer

// material: metallic, roughness.
GgxSurface ggx_surface(vec3 base_colour, vec2 material, vec3 normal, vec3 to_eye) {
  float roughness = max(material.y, MIN_LIGHT_ROUGHNESS);
  vec3 f0 = fresnel_f0(base_colour, material.x);
  return GgxSurface(normal, to_eye, clamp(ordered_dot(normal, to_eye), MIN_COS_VIEW, 1.0), roughness * roughness, f0,
                    fresnel_f90(f0), base_colour * (1.0 - material.x));
}

// From where the surface shows the environment; the lobe is the one seen along the normal.
vec3 mirrored(GgxSurface surface) { return ordered_reflect(-surface.to_eye, surface.normal); }

#endif
