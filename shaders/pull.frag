// The pull of push-pull: one mip of what is known from the mip before, by exact areas. A texel that covers any known
// one is known; its colour is their mean (Gortler et al., "The Lumigraph", SIGGRAPH 1996, with weights
// that saturate at once, so that holes are filled from the nearest known pixels alone), its alpha the mean of all
// alphas: how much of it is known.
//
// In: finer, straight alpha, 0 where unknown. Out: the same. Colours are weighed by their alpha.
// Summed are differences from one known colour, so that a constant keeps its bits.
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
  vec4 corner = texelFetch(finer, 2 * texel, 0);
  vec3 first = corner.rgb;
  vec4 sum = vec4(0.0);  // differences from `first` times alpha; from the corner's alpha
  float alpha_sum = 0.0;
  for (int y = 0; y < taps.y; ++y) {
    for (int x = 0; x < taps.x; ++x) {
      vec4 found = texelFetch(finer, 2 * texel + ivec2(x, y), 0);
      float weight = weights_x[x] * weights_y[y];
      first = alpha_sum > 0.0 ? first : found.rgb;
      sum += weight * vec4(found.a * (found.rgb - first), found.a - corner.a);
      alpha_sum += weight * found.a;
    }
  }
  coarser = alpha_sum > 0.0 ? vec4(first + sum.rgb / alpha_sum, corner.a + sum.a) : vec4(0.0);
}
