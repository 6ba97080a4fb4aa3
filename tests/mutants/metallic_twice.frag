// Mutant of composite_metallic.frag: the composite as KongEngine first had it, metallic twice.
//
// In: lit, reflection, material. Out: composite, linear radiance; the lit image itself on a miss.
#version 450
#include "composite_forms.glsl"

layout(binding = 1) uniform sampler2D lit;
layout(binding = 2) uniform sampler2D reflection;
layout(binding = 3) uniform sampler2D material;

layout(location = 0) out vec4 composite;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 found = texelFetch(reflection, texel, 0);
  vec3 radiance = texelFetch(lit, texel, 0).rgb;
  vec4 weighed = found * texelFetch(material, texel, 0).r;
  composite = vec4(radiance + weighed.rgb * weighed.a, 1.0);
}
