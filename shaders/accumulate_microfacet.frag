// Adds one sample to the reflected radiance: what its ray met, as much of it as the microfacet sends to the eye.
//
// In:  hit_texel, lit, microfacet_normal, normal_view, albedo, material, dist_view; reflected_sum of the samples so
//      far, read from the second sample on.
// Out: reflected_sum_next, rgb radiance towards the eye, a the number of rays that hit.
#version 450
#include "microfacet.glsl"
#include "sky.glsl"

layout(std140, binding = 0) uniform AccumulateBlock {
  vec2 px_offset;
  vec2 view_per_px;
  vec3 up_view;
  vec3 sky_horizon;
  vec3 sky_zenith;
  int sample_index;
};

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D lit;
layout(binding = 3) uniform sampler2D microfacet_normal;
layout(binding = 4) uniform sampler2D normal_view;
layout(binding = 5) uniform sampler2D albedo;
layout(binding = 6) uniform sampler2D material;
layout(binding = 7) uniform sampler2D dist_view;
layout(binding = 8) uniform sampler2D reflected_sum;

layout(location = 0) out vec4 reflected_sum_next;

vec4 sampled_radiance(ivec2 texel) {
  vec4 surface = texelFetch(material, texel, 0);
  if (surface.b == 0.0 || isinf(texelFetch(dist_view, texel, 0).x)) {
    return vec4(0.0);
  }
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec3 normal = ordered_normalize(texelFetch(normal_view, texel, 0).xyz);
  vec3 microfacet = ordered_normalize(texelFetch(microfacet_normal, texel, 0).xyz);
  vec3 f0 = fresnel_f0(texelFetch(albedo, texel, 0).rgb, surface.r);
  vec3 weight = microfacet_weight(normal, microfacet, from_eye, surface.g, f0);
  float elevation = ordered_dot(ordered_reflect(from_eye, microfacet), up_view);
  ivec2 hit = texelFetch(hit_texel, texel, 0).xy;
  bool is_hit = hit.x >= 0;
  vec3 arriving = is_hit ? texelFetch(lit, hit, 0).rgb : sky_radiance(elevation, sky_horizon, sky_zenith);
  return vec4(weight * arriving, is_hit ? 1.0 : 0.0);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 before = texelFetch(reflected_sum, texel, 0);
  before = sample_index > 0 ? before : vec4(0.0);
  reflected_sum_next = before + sampled_radiance(texel);
}
