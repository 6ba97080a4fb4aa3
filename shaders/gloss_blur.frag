// Blurs the reflection along one axis, by each pixel's own radius, and not across edges of depth or normal: run along
// x, then along y (Wronski, "Assassin's Creed IV: Black Flag, Road to Next-Gen Graphics", GDC 2014).
//
// In:  source (straight alpha), blur_guide, normal_view. along_y: 0 or 1. narrow: 1 for the kernel as wide as the gaps
//      between the taps of the other one; run before it, it keeps them from showing as a comb.
// Out: the blurred reflection, straight alpha.
// Colours are summed times their alpha and divided by the sum of alphas. A miss has no colour, its rgb is 0: summed
// without alpha, it would draw a dark rim around all that is reflected. Summed are differences from the first colour,
// so that a constant keeps its bits where halves are stored rounded towards zero. Between two pixels the smaller of
// their radii counts, from either side: what touches the mirror stays sharp beside a blurred far wall, and both sides
// of a silhouette soften alike.
#version 450
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

const float MAX_TAPS = 12.0;          // to each side; a larger radius spaces them out
const float NARROW_SPACINGS = 2.0;    // radius of the narrow kernel: four of them meet between taps, within 1 %
const float PLANE_TOLERANCE = 0.01;   // of dist_view: further off the pixel's plane is another surface
const float LEAST_NORMAL_COSINE = 0.9;

layout(std140, binding = 0) uniform BlurBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  int along_y;
  int narrow;
};

layout(binding = 1) uniform sampler2D source;
layout(binding = 2) uniform sampler2D blur_guide;
layout(binding = 3) uniform sampler2D normal_view;

layout(location = 0) out vec4 blurred;

vec3 position_view(vec2 p_px, float dist_view) {
  return position_px_to_view(p_px, dist_view, PixelProjection(px_scale, px_offset, view_per_px));
}

// Between the taps of a kernel; whole, so that all gaps are alike.
float spacing_of(float radius_px) { return max(ceil(radius_px / MAX_TAPS), 1.0); }

// x dist_view, y radius of the kernel in pixels.
vec2 load_guide(vec2 p_px) {
  vec2 guide = textureLod(blur_guide, p_px * texel_uv, 0.0).xy;
  float spacing_px = spacing_of(guide.y);
  return vec2(guide.x, narrow == 0 ? guide.y : spacing_px > 1.0 ? NARROW_SPACINGS * spacing_px : 0.0);
}

// 1 - x^2, squared: near to a Gaussian, and exactly 0 from x = 1 on.
float kernel(float x) {
  float fall = max(1.0 - x * x, 0.0);
  return fall * fall;
}

// 0 for another surface: off the plane of this one, or turned away from it.
float same_surface(vec3 p_view, vec3 normal, float dist_view, vec2 other_px, float other_dist_view) {
  float off_plane_m = abs(ordered_dot(normal, position_view(other_px, other_dist_view) - p_view));
  float plane = max(1.0 - off_plane_m / (PLANE_TOLERANCE * dist_view), 0.0);
  if (plane == 0.0) {
    return 0.0;
  }
  float cosine = ordered_dot(normal, textureLod(normal_view, other_px * texel_uv, 0.0).xyz);
  return plane * max((cosine - LEAST_NORMAL_COSINE) / (1.0 - LEAST_NORMAL_COSINE), 0.0);
}

void main() {
  vec2 p_px = gl_FragCoord.xy;
  vec4 own = textureLod(source, p_px * texel_uv, 0.0);
  vec2 guide = load_guide(p_px);
  blurred = own;
  if (guide.y <= 1.0) {
    return;
  }
  vec3 p_view = position_view(p_px, guide.x);
  vec3 normal = textureLod(normal_view, p_px * texel_uv, 0.0).xyz;
  vec2 axis = along_y != 0 ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  float spacing_px = spacing_of(guide.y);
  int taps = int(min(ceil(guide.y), MAX_TAPS));
  vec3 first = own.rgb;
  vec4 sum = vec4(0.0);  // differences from `first` times alpha; from the own alpha
  float alpha_sum = own.a;
  float weight_sum = 1.0;
  for (int tap = -taps; tap <= taps; ++tap) {
    float offset_px = float(tap) * spacing_px;
    vec2 other_px = p_px + offset_px * axis;
    bool is_inside = all(greaterThan(other_px, vec2(0.0))) && all(lessThan(other_px, size_px));
    if (tap != 0 && is_inside) {
      vec2 other_guide = load_guide(other_px);
      float radius_px = min(guide.y, other_guide.y);
      float weight = radius_px > 0.0 ? kernel(offset_px / radius_px) : 0.0;
      weight = weight > 0.0 ? weight * same_surface(p_view, normal, guide.x, other_px, other_guide.x) : 0.0;
      if (weight > 0.0) {
        vec4 found = textureLod(source, other_px * texel_uv, 0.0);
        first = alpha_sum > 0.0 ? first : found.rgb;
        sum += weight * vec4(found.a * (found.rgb - first), found.a - own.a);
        alpha_sum += weight * found.a;
        weight_sum += weight;
      }
    }
  }
  blurred = vec4(first + (alpha_sum > 0.0 ? sum.rgb / alpha_sum : vec3(0.0)), own.a + sum.a / weight_sum);
}
