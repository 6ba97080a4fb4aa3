// Mutant: a random vector with components in 0..1.
#version 450
#include "jittered_normal.glsl"
#include "microfacet.glsl"
#include "random.glsl"

layout(std140, binding = 0) uniform JitterBlock {
  vec2 px_offset;
  vec2 view_per_px;
  int sample_index;
  int sample_count;
  int point_set;
};

layout(binding = 1) uniform sampler2D normal_view;
layout(binding = 2) uniform sampler2D material;

layout(location = 0) out vec4 microfacet_normal;

vec3 octant_jitter(vec3 normal, float roughness, vec3 components) {
  return ordered_normalize(normal + (JITTER_STRENGTH * roughness) * components);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  microfacet_normal = texelFetch(normal_view, texel, 0);
  float roughness = texelFetch(material, texel, 0).g;
  if (is_mirror(roughness)) {
    return;
  }
  vec3 normal = ordered_normalize(microfacet_normal.xyz);
  vec3 jittered = octant_jitter(normal, roughness, white_noise(texel, sample_index));
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec3 reflected = ordered_reflect(from_eye, jittered);
  microfacet_normal = vec4(jittered, microfacet_clearance(microfacet_normal, normal, from_eye, reflected));
}
