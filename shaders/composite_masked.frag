// Blends each reflection in by metalness, Fresnel and the hit's distance from the screen's centre; where metalness is 0
// the lit colour stays as it is.
//
// In: lit, reflection, hit_point, albedo, normal_view, material. Out: composite, linear radiance.
#version 450
#include "composite_forms.glsl"
#include "ssr_ordered.glsl"

layout(std140, binding = 0) uniform MaskedBlock {
  vec2 size_px;
  vec2 px_offset;
  vec2 view_per_px;
};

layout(binding = 1) uniform sampler2D lit;
layout(binding = 2) uniform sampler2D reflection;
layout(binding = 3) uniform sampler2D hit_point;
layout(binding = 4) uniform sampler2D albedo;
layout(binding = 5) uniform sampler2D normal_view;
layout(binding = 6) uniform sampler2D material;

layout(location = 0) out vec4 composite;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 radiance = texelFetch(lit, texel, 0).rgb;
  vec4 found = texelFetch(reflection, texel, 0);
  float metallic = texelFetch(material, texel, 0).r;
  if (metallic > 0.0 && found.a > 0.0) {
    vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
    vec3 normal = ordered_normalize(texelFetch(normal_view, texel, 0).xyz);
    float cosine = clamp(-ordered_dot(from_eye, normal), 0.0, 1.0);
    vec3 fresnel = fresnel_schlick(fresnel_f0(texelFetch(albedo, texel, 0).rgb, metallic), cosine);
    float centre = centre_weight(texelFetch(hit_point, texel, 0).xy, size_px);
    radiance = composite_blended(radiance, found.rgb, (metallic * centre * found.a) * fresnel);
  }
  composite = vec4(radiance, 1.0);
}
