// The mean of a pixel's samples.
//
// In:  reflected_sum of sample_count samples. Out: reflection, rgb radiance that the surface reflects towards the eye
//      (Fresnel and masking are in it already), a share of the rays that hit.
#version 450

layout(std140, binding = 0) uniform AverageBlock { int sample_count; };

layout(binding = 1) uniform sampler2D reflected_sum;

layout(location = 0) out vec4 reflection;

void main() { reflection = texelFetch(reflected_sum, ivec2(gl_FragCoord.xy), 0) / float(sample_count); }
