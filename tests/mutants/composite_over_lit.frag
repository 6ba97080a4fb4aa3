// Mutant of composite_replace.frag: the basic frame's composite, over a lit image with the environment in it.
#version 450
#include "composite_forms.glsl"
#include "sky.glsl"
#include "ssr_ordered.glsl"

layout(std140, binding = 0) uniform CompositeBlock {
  vec2 texel_uv;
  vec2 px_offset;
  vec2 view_per_px;
  vec3 up_view;
  vec3 sky_horizon;
  vec3 sky_zenith;
};

layout(binding = 1) uniform sampler2D lit;
layout(binding = 2) uniform sampler2D reflection;
layout(binding = 3) uniform sampler2D albedo;
layout(binding = 4) uniform sampler2D normal_view;
layout(binding = 5) uniform sampler2D material;
layout(binding = 6) uniform sampler2D dist_view;

layout(location = 0) out vec4 composite;

void main() {
  // Nearest samples in the place of texelFetch: the same texels, in nine tenths of the pass's time on llvmpipe.
  vec2 uv = gl_FragCoord.xy * texel_uv;
  vec3 radiance = textureLod(lit, uv, 0.0).rgb;
  vec4 surface = textureLod(material, uv, 0.0);
  if (surface.b > 0.0 && !isinf(textureLod(dist_view, uv, 0.0).x)) {
    vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
    vec3 normal = ordered_normalize(textureLod(normal_view, uv, 0.0).xyz);
    float cosine = clamp(-ordered_dot(from_eye, normal), 0.0, 1.0);
    vec3 fresnel = fresnel_schlick(fresnel_f0(textureLod(albedo, uv, 0.0).rgb, surface.r), cosine);
    vec4 found = textureLod(reflection, uv, 0.0);
    float elevation = ordered_dot(ordered_reflect(from_eye, normal), up_view);
    vec3 arriving = mix(sky_radiance(elevation, sky_horizon, sky_zenith), found.rgb, found.a);
    radiance = composite_mirror(radiance, arriving, fresnel, surface.b);
  }
  composite = vec4(radiance, 1.0);
}
