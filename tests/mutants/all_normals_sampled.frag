// Mutant: draws from all microfacets, as if the eye saw every one alike.
#version 450
#include "microfacet.glsl"
#include "random.glsl"

layout(std140, binding = 0) uniform SampleBlock {
  vec2 px_offset;
  vec2 view_per_px;
  int sample_index;
  int sample_count;
  int point_set;
};

layout(binding = 1) uniform sampler2D normal_view;
layout(binding = 2) uniform sampler2D material;
layout(binding = 3) uniform sampler2D blue_noise;

layout(location = 0) out vec4 microfacet_normal;

// Walter et al. 2007, equation 35: the distribution D cosine.
vec4 any_microfacet(vec4 normal_and_clearance, vec3 from_eye, float roughness, vec2 point) {
  vec3 normal = ordered_normalize(normal_and_clearance.xyz);
  float tangent = ggx_alpha(roughness) * sqrt(point.y / (1.0 - point.y));
  vec3 local = ordered_normalize(vec3(tangent * unit_circle(point.x), 1.0));
  vec3 microfacet = from_frame(frame_about(normal), local);
  vec3 reflected = ordered_reflect(from_eye, microfacet);
  return vec4(microfacet, microfacet_clearance(normal_and_clearance, normal, from_eye, reflected));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec2 mask = texelFetch(blue_noise, texel & (BLUE_NOISE_SIDE - 1), 0).xy;
  vec2 point = pixel_point(texel, sample_index, sample_count, point_set, mask);
  float roughness = texelFetch(material, texel, 0).g;
  microfacet_normal = any_microfacet(texelFetch(normal_view, texel, 0), from_eye, roughness, point);
}
