// Adds what one sample's ray hit, weighed by as much of it as gets out of the surface, for a composite that knows
// Fresnel and the environment itself.
//
// In:  hit_texel, lit, microfacet_normal, normal_view, material, dist_view; reflected_sum and weight_sum of the samples
//      so far, read from the second sample on.
// Out: reflected_sum_next, rgb weighed radiance hit, a the weight of the rays that hit; weight_sum_next, that of all.
#version 450
#include "microfacet.glsl"

layout(std140, binding = 0) uniform AccumulateBlock {
  vec2 px_offset;
  vec2 view_per_px;
  int sample_index;
};

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D lit;
layout(binding = 3) uniform sampler2D microfacet_normal;
layout(binding = 4) uniform sampler2D normal_view;
layout(binding = 5) uniform sampler2D material;
layout(binding = 6) uniform sampler2D dist_view;
layout(binding = 7) uniform sampler2D reflected_sum;
layout(binding = 8) uniform sampler2D weight_sum;

layout(location = 0) out vec4 reflected_sum_next;
layout(location = 1) out float weight_sum_next;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 reflected_before = texelFetch(reflected_sum, texel, 0);
  float weight_before = texelFetch(weight_sum, texel, 0).x;
  reflected_sum_next = sample_index > 0 ? reflected_before : vec4(0.0);
  weight_sum_next = sample_index > 0 ? weight_before : 0.0;
  vec4 surface = texelFetch(material, texel, 0);
  if (surface.b == 0.0 || isinf(texelFetch(dist_view, texel, 0).x)) {
    return;
  }
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec3 normal = ordered_normalize(texelFetch(normal_view, texel, 0).xyz);
  vec3 microfacet = ordered_normalize(texelFetch(microfacet_normal, texel, 0).xyz);
  float weight = microfacet_weight(normal, microfacet, from_eye, surface.g, vec3(1.0)).x;
  ivec2 hit = texelFetch(hit_texel, texel, 0).xy;
  reflected_sum_next += hit.x >= 0 ? weight * vec4(texelFetch(lit, hit, 0).rgb, 1.0) : vec4(0.0);
  weight_sum_next += weight;
}
