// Mutant: the sum of the samples, not their mean.
#version 450

layout(binding = 1) uniform sampler2D reflected_sum;

layout(location = 0) out vec4 reflection;

void main() { reflection = texelFetch(reflected_sum, ivec2(gl_FragCoord.xy), 0); }
