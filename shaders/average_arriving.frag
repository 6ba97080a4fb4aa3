// The mean of what a pixel's rays hit.
//
// In:  reflected_sum, weight_sum (accumulate_arriving.frag). Out: reflection, rgb mean radiance hit, 0 without any hit;
//      a the hits' share of the weight.
#version 450

layout(binding = 1) uniform sampler2D reflected_sum;
layout(binding = 2) uniform sampler2D weight_sum;

layout(location = 0) out vec4 reflection;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(reflected_sum, texel, 0);
  reflection = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / texelFetch(weight_sum, texel, 0).x) : vec4(0.0);
}
