// Moves each rough pixel's normal about at random for the tracer to reflect its ray at.
//
// In:  normal_view, material (g roughness). sample_index of sample_count; point_set (random.glsl).
// Out: microfacet_normal, in the layout of normal_view; its bits where the surface is a mirror.
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
layout(binding = 3) uniform sampler2D blue_noise;

layout(location = 0) out vec4 microfacet_normal;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  microfacet_normal = texelFetch(normal_view, texel, 0);
  float roughness = texelFetch(material, texel, 0).g;
  if (is_mirror(roughness)) {
    return;
  }
  vec3 normal = ordered_normalize(microfacet_normal.xyz);
  vec2 mask = texelFetch(blue_noise, texel & (BLUE_NOISE_SIDE - 1), 0).xy;
  vec2 point = pixel_point(texel, sample_index, sample_count, point_set, mask);
  vec3 jittered = jittered_normal(normal, roughness, point);
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec3 reflected = ordered_reflect(from_eye, jittered);
  microfacet_normal = vec4(jittered, microfacet_clearance(microfacet_normal, normal, from_eye, reflected));
}
