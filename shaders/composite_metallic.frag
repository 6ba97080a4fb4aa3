// KongEngine's composite, with metallic once: adds each reflection in the measure that its surface is a metal.
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
  composite = vec4(composite_metallic(radiance, found, texelFetch(material, texel, 0).r), 1.0);
}
