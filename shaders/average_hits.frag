// The mean of what a pixel's rays hit, for the plain composite.
//
// In:  reflected_sum of sample_count samples, rgb radiance hit, a hits.
// Out: reflection, rgb mean radiance of the hits (0 without any), a share of the rays that hit.
#version 450

layout(std140, binding = 0) uniform AverageBlock { int sample_count; };

layout(binding = 1) uniform sampler2D reflected_sum;

layout(location = 0) out vec4 reflection;

void main() {
  vec4 sum = texelFetch(reflected_sum, ivec2(gl_FragCoord.xy), 0);
  reflection = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / float(sample_count)) : vec4(0.0);
}
