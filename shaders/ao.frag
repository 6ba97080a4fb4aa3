// Ambient obscurance of each pixel, before its noise is blurred away (ao_blur.frag).
//
// The noise is a pattern of 4 x 4 pixels, so that a blur over four pixels each way meets every turn of the samples
// once.
// In: dist_view, normal_view. Out: ao_noisy, r the visibility, g dist_view for the blur to tell edges by. Background:
// 1.
#version 450
#extension GL_EXT_control_flow_attributes : require
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

layout(constant_id = 0) const int ao_sample_count = 8;

layout(std140, binding = 0) uniform AoBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  float near_m;
  float ao_radius_m;
  float ao_thickness_m;
};

layout(binding = 1) uniform sampler2D dist_view;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out vec2 ao_noisy;

// A nearest sample instead of texelFetch: the same texel, and 1.7 times as fast on llvmpipe.
float load_dist_view(vec2 texel) { return textureLod(dist_view, (texel + 0.5) * texel_uv, 0.0).x; }

#include "ambient_occlusion.glsl"

// 0 to 15 over 4 x 4 pixels: two bits of x and y interleaved, so that near numbers are apart (a Bayer matrix).
float pattern_index(ivec2 texel) {
  int x = texel.x & 3;
  int y = texel.y & 3;
  int crossed = x ^ y;
  return float((crossed & 1) * 8 + (y & 1) * 4 + (crossed >> 1) * 2 + (y >> 1));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float dist = load_dist_view(vec2(texel));
  if (isinf(dist)) {
    ao_noisy = vec2(1.0, dist);
    return;
  }
  PixelProjection projection = PixelProjection(px_scale, px_offset, view_per_px);
  vec3 p_view = position_px_to_view(vec2(texel) + 0.5, dist, projection);
  vec3 normal = ordered_normalize(textureLod(normal_view, (vec2(texel) + 0.5) * texel_uv, 0.0).xyz);
  float index = pattern_index(texel);
  vec3 noise = fract((vec3(1.0, 7.0, 5.0) * index + 0.5) / 16.0);  // sixteen different ones of each
  AoParameters parameters = AoParameters(ao_radius_m, ao_thickness_m, ao_sample_count, size_px, near_m);
  ao_noisy = vec2(ambient_visibility(p_view, normal, noise, projection, parameters), dist);
}
