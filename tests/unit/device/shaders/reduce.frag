// Minimum of 2 x 2 texels of the level above: what a pyramid pass does.
#version 450

layout(binding = 0) uniform sampler2D finer;

layout(location = 0) out float least;

void main() {
  ivec2 texel = 2 * ivec2(gl_FragCoord.xy);
  vec2 upper = min(texelFetch(finer, texel, 0).xx, texelFetch(finer, texel + ivec2(1, 0), 0).xx);
  vec2 lower = min(texelFetch(finer, texel + ivec2(0, 1), 0).xx, texelFetch(finer, texel + ivec2(1, 1), 0).xx);
  least = min(upper.x, lower.x);
}
