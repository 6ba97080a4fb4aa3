// Adds what one sample's ray hit, unweighed.
//
// In:  hit_texel, lit; reflected_sum of the samples so far, read from the second sample on.
// Out: reflected_sum_next, rgb sum of the radiance hit, a the number of rays that hit.
#version 450

layout(std140, binding = 0) uniform AccumulateBlock { int sample_index; };

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D lit;
layout(binding = 3) uniform sampler2D reflected_sum;

layout(location = 0) out vec4 reflected_sum_next;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 before = texelFetch(reflected_sum, texel, 0);
  before = sample_index > 0 ? before : vec4(0.0);
  ivec2 hit = texelFetch(hit_texel, texel, 0).xy;
  reflected_sum_next = before + (hit.x >= 0 ? vec4(texelFetch(lit, hit, 0).rgb, 1.0) : vec4(0.0));
}
