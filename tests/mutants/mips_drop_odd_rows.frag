// Mutant of mips_reduce.frag: two texels an axis, at odd sizes too.
//
// In: finer, linear radiance. Out: the mip. A constant image keeps its bits at every size: summed are the differences
// from one texel, for drivers round what they store in halves towards zero, and a sum of weights is rarely exactly 1.
#version 450
#include "box_filter.glsl"

layout(binding = 1) uniform sampler2D finer;

layout(location = 0) out vec4 coarser;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 finer_size = textureSize(finer, 0);
  vec3 weights_x = box_weights(texel.x, 2 * max(finer_size.x / 2, 1) - int(finer_size.x == 1));
  vec3 weights_y = box_weights(texel.y, 2 * max(finer_size.y / 2, 1) - int(finer_size.y == 1));
  ivec2 taps = min(ivec2(2), finer_size);
  vec4 first = texelFetch(finer, 2 * texel, 0);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < taps.y; ++y) {
    for (int x = 0; x < taps.x; ++x) {
      sum += weights_x[x] * weights_y[y] * (texelFetch(finer, 2 * texel + ivec2(x, y), 0) - first);
    }
  }
  coarser = first + sum;
}
