// Which texels of the previous frame show the same surface, around a position on it.
//
// Needs, defined before: float load_previous_dist_view(ivec2 texel), metres; 0 where there is no previous frame.
// A texel counts when its point lies on the predicted plane, to within `tolerance_rel` of the distance. The plane, not
// the depth alone: a floor's depth changes from row to row by more than two surfaces of a thin thing are apart.
// Out: the weights of bilinear interpolation over the texels that count, with sum 1, or all 0 where none does: the
//   surface was hidden, outside of the image, or there is no history. At a texel's centre the weights are 1, 0, 0, 0.
#ifndef HISTORY_TAPS_GLSL
#define HISTORY_TAPS_GLSL

#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

const float LEAST_WEIGHT = 1e-3;  // of all taps together: less is rounding of a position beside the surface

struct HistoryTaps {
  ivec2 first;   // the upper left texel of the four
  vec4 weights;  // of first + (0, 0), (1, 0), (0, 1), (1, 1)
};

struct PredictedSurface {
  vec3 p_view;  // in the previous view space
  vec3 normal;
};

float tap_counts(ivec2 texel, PredictedSurface surface, float tolerance_rel, ivec2 size, PixelProjection projection) {
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size))) {
    return 0.0;
  }
  float dist = load_previous_dist_view(texel);
  if (dist <= 0.0 || isinf(dist)) {
    return 0.0;
  }
  vec3 p_view = position_px_to_view(vec2(texel) + 0.5, dist, projection);
  float off_plane_m = abs(ordered_dot(surface.normal, p_view - surface.p_view));
  return off_plane_m <= tolerance_rel * dist ? 1.0 : 0.0;
}

HistoryTaps history_taps(vec2 p_px, PredictedSurface surface, float tolerance_rel, vec2 size_px,
                         PixelProjection projection) {
  HistoryTaps taps = HistoryTaps(ivec2(0), vec4(0.0));
  // Also keeps infinities from becoming integers.
  if (!(all(greaterThan(p_px, vec2(-1.0))) && all(lessThan(p_px, size_px + 1.0)))) {
    return taps;
  }
  vec2 corner = floor(p_px - 0.5);
  vec2 share = (p_px - 0.5) - corner;
  taps.first = ivec2(corner);
  ivec2 size = ivec2(size_px);
  taps.weights = vec4(
      (1.0 - share.x) * (1.0 - share.y) * tap_counts(taps.first, surface, tolerance_rel, size, projection),
      share.x * (1.0 - share.y) * tap_counts(taps.first + ivec2(1, 0), surface, tolerance_rel, size, projection),
      (1.0 - share.x) * share.y * tap_counts(taps.first + ivec2(0, 1), surface, tolerance_rel, size, projection),
      share.x * share.y * tap_counts(taps.first + ivec2(1, 1), surface, tolerance_rel, size, projection));
  float sum = (taps.weights.x + taps.weights.y) + (taps.weights.z + taps.weights.w);
  taps.weights = sum > LEAST_WEIGHT ? taps.weights / sum : vec4(0.0);
  return taps;
}

// One of the four, x and y 0 or 1. Inside of the image, also where the tap is not and its weight is 0.
ivec2 tap_texel(HistoryTaps taps, int x, int y, vec2 size_px) {
  return clamp(taps.first + ivec2(x, y), ivec2(0), ivec2(size_px) - 1);
}

bool has_history(HistoryTaps taps) { return any(greaterThan(taps.weights, vec4(0.0))); }

// The four texels' weighed sum. A texel of weight 0 adds nothing, whatever it holds.
vec4 weighed_sum(HistoryTaps taps, vec4 upper_left, vec4 upper_right, vec4 lower_left, vec4 lower_right) {
  vec4 sum = taps.weights.x > 0.0 ? taps.weights.x * upper_left : vec4(0.0);
  sum += taps.weights.y > 0.0 ? taps.weights.y * upper_right : vec4(0.0);
  sum += taps.weights.z > 0.0 ? taps.weights.z * lower_left : vec4(0.0);
  sum += taps.weights.w > 0.0 ? taps.weights.w * lower_right : vec4(0.0);
  return sum;
}

#endif
