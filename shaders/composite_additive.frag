// INF584's composite: adds the lit colour at each ray's texel, times its visibility.
//
// In: lit, hit_texel, visibility. Out: composite, linear radiance; the lit image itself on a miss.
#version 450
#include "composite_forms.glsl"

layout(binding = 1) uniform sampler2D lit;
layout(binding = 2) uniform isampler2D hit_texel;
layout(binding = 3) uniform sampler2D visibility;

layout(location = 0) out vec4 composite;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 radiance = texelFetch(lit, texel, 0).rgb;
  ivec2 hit = texelFetch(hit_texel, texel, 0).xy;
  if (hit.x >= 0) {
    radiance = composite_additive(radiance, texelFetch(lit, hit, 0).rgb, texelFetch(visibility, texel, 0).x);
  }
  composite = vec4(radiance, 1.0);
}
