// Adds reflected radiance to the lit image: its Fresnel, masking and sky were weighed sample by sample.
//
// In: lit, reflection (rgb radiance towards the eye), material (b: reflective). Out: composite, linear radiance.
#version 450

layout(binding = 1) uniform sampler2D lit;
layout(binding = 2) uniform sampler2D reflection;
layout(binding = 3) uniform sampler2D material;

layout(location = 0) out vec4 composite;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 reflected = texelFetch(material, texel, 0).b * texelFetch(reflection, texel, 0).rgb;
  composite = vec4(texelFetch(lit, texel, 0).rgb + reflected, 1.0);
}
