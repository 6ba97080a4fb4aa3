// Mutant of gloss_blur.frag: does not stop at steps of depth.
// then along y (Wronski, "Assassin's Creed IV: Black Flag, Road to Next-Gen Graphics", GDC 2014).
//
// In:  source (straight alpha), blur_guide, normal_view, dist_view as blur_guide's x. along_y: 0 or 1.
// Out: the blurred reflection, straight alpha.
// Colours are summed times their alpha and divided by the sum of alphas. A miss has no colour, its rgb is 0: summed
// without alpha, it would draw a dark rim around all that is reflected. Summed are differences from the first colour, so
// that a constant keeps its bits where halves are stored rounded towards zero.
// Between two pixels the smaller of their radii counts, from either side: what touches the mirror stays sharp beside a
// blurred far wall, and both sides of a silhouette soften alike.
#version 450
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

const float MAX_TAPS = 12.0;          // to each side; a larger radius spaces them out
const float PLANE_TOLERANCE = 0.01;   // of dist_view: further off the pixel's plane is another surface
const float LEAST_NORMAL_COSINE = 0.9;

layout(std140, binding = 0) uniform BlurBlock {
  vec2 size_px;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  int along_y;
};

layout(binding = 1) uniform sampler2D source;
layout(binding = 2) uniform sampler2D blur_guide;
layout(binding = 3) uniform sampler2D normal_view;

layout(location = 0) out vec4 blurred;

vec3 position_view(ivec2 texel, float dist_view) {
  return position_px_to_view(vec2(texel) + 0.5, dist_view, PixelProjection(px_scale, px_offset, view_per_px));
}

// 1 - x^2, squared: near to a Gaussian, and exactly 0 from x = 1 on.
float kernel(float x) {
  float fall = max(1.0 - x * x, 0.0);
  return fall * fall;
}

// 0 for another surface: off the plane of this one, or turned away from it.
float same_surface(vec3 p_view, vec3 normal, float dist_view, ivec2 other, float other_dist_view) {
  float plane = 1.0;
  if (plane == 0.0) {
    return 0.0;
  }
  float cosine = ordered_dot(normal, texelFetch(normal_view, other, 0).xyz);
  return plane * max((cosine - LEAST_NORMAL_COSINE) / (1.0 - LEAST_NORMAL_COSINE), 0.0);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 own = texelFetch(source, texel, 0);
  vec2 guide = texelFetch(blur_guide, texel, 0).xy;
  blurred = own;
  if (guide.y <= 1.0) {
    return;
  }
  vec3 p_view = position_view(texel, guide.x);
  vec3 normal = texelFetch(normal_view, texel, 0).xyz;
  ivec2 axis = along_y != 0 ? ivec2(0, 1) : ivec2(1, 0);
  float spacing_px = max(guide.y / MAX_TAPS, 1.0);
  int taps = int(min(ceil(guide.y), MAX_TAPS));
  vec3 first = own.rgb;
  vec4 sum = vec4(0.0);  // differences from `first` times alpha; from the own alpha
  float alpha_sum = own.a;
  float weight_sum = 1.0;
  for (int tap = -taps; tap <= taps; ++tap) {
    ivec2 offset = axis * int(round(float(tap) * spacing_px));
    ivec2 other = texel + offset;
    bool is_inside = all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, ivec2(size_px)));
    if (tap != 0 && is_inside) {
      vec2 other_guide = texelFetch(blur_guide, other, 0).xy;
      float radius_px = min(guide.y, other_guide.y);
      float weight = radius_px > 0.0 ? kernel(float(offset.x + offset.y) / radius_px) : 0.0;
      weight = weight > 0.0 ? weight * same_surface(p_view, normal, guide.x, other, other_guide.x) : 0.0;
      if (weight > 0.0) {
        vec4 found = texelFetch(source, other, 0);
        first = alpha_sum > 0.0 ? first : found.rgb;
        sum += weight * vec4(found.a * (found.rgb - first), found.a - own.a);
        alpha_sum += weight * found.a;
        weight_sum += weight;
      }
    }
  }
  blurred = vec4(first + (alpha_sum > 0.0 ? sum.rgb / alpha_sum : vec3(0.0)), own.a + sum.a / weight_sum);
}
