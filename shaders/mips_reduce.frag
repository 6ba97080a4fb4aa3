// One mip of an image from the mip before, by exact areas (include/box_filter.glsl).
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
  vec3 weights_x = box_weights(texel.x, finer_size.x);
  vec3 weights_y = box_weights(texel.y, finer_size.y);
  ivec2 taps = min(2 + (finer_size & 1), finer_size);
  vec4 first = texelFetch(finer, 2 * texel, 0);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < taps.y; ++y) {
    for (int x = 0; x < taps.x; ++x) {
      sum += weights_x[x] * weights_y[y] * (texelFetch(finer, 2 * texel + ivec2(x, y), 0) - first);
    }
  }
  coarser = first + sum;
}
