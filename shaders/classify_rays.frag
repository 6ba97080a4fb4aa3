// Sorts the reflective pixels before the trace: mirrors get their one exact ray, glossy surfaces one at a sampled
// visible microfacet, and surfaces too rough for a single ray to say anything none, so they cost no lookup.
//
// In:  normal_view, material (g roughness, b 1 where rays are traced), blue_noise; max_traced_roughness.
// Out: microfacet_normal, in the layout of normal_view; ray_material, material with b = 0 where no ray is traced.
// (The classes of AMD's FidelityFX SSSR, ClassifyTiles.)
#version 450
#include "microfacet.glsl"
#include "random.glsl"

layout(std140, binding = 0) uniform ClassifyBlock {
  vec2 px_offset;
  vec2 view_per_px;
  float max_traced_roughness;
};

layout(binding = 1) uniform sampler2D normal_view;
layout(binding = 2) uniform sampler2D material;
layout(binding = 3) uniform sampler2D blue_noise;

layout(location = 0) out vec4 microfacet_normal;
layout(location = 1) out vec4 ray_material;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(material, texel, 0);
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec2 point = texelFetch(blue_noise, texel & (BLUE_NOISE_SIDE - 1), 0).xy;
  microfacet_normal = microfacet_of(texelFetch(normal_view, texel, 0), from_eye, surface.g, point);
  ray_material = vec4(surface.rg, surface.g > max_traced_roughness ? 0.0 : surface.b, surface.a);
}
