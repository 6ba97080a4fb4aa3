// The tracing contract: what every tracer is asked and what it answers (docs/spaces.md).
//
// Texel (i, j) of the depth image is a column: its footprint on the image, from dist_view Z to Z + T. Background is
// Z = +inf and is never hit. A ray hits the first texel, other than its own, in whose footprint its dist_view
// interval overlaps [Z, Z + T).
#ifndef SSR_CONTRACT_GLSL
#define SSR_CONTRACT_GLSL

#include "ssr_ordered.glsl"

const int RAY_MASKED = 0;
const int RAY_BACKGROUND = 1;
const int RAY_HIT = 2;
const int RAY_OFFSCREEN = 3;
const int RAY_RANGE = 4;
const int RAY_BUDGET = 5;
const int RAY_INTO_SURFACE = 6;

struct TraceParameters {
  vec2 size_px;
  float near_m;
  float thickness_m;    // 1e30 stands for infinite
  float thickness_rel;  // fraction of dist_view
  float max_distance_m; // 1e30 stands for infinite
  float origin_bias;    // fraction of dist_view, along the normal
  int lookup_budget;
  int step_count;       // marches along the 3-D ray; capped: the most samples
  float step_m;         // marches along the 3-D ray; 0: taken from step_count
  int bisection_count;  // refined, exponential, adaptive, homogeneous, capped, dda with a stride over 1
  float stride_px;      // dda, homogeneous, capped
  float jitter;         // 0..1 of a step
  int max_mip;          // hiz
  float step_growth;    // exponential, adaptive: a step's length over that of the one before
  float first_step_share;  // exponential: of the ray, so that step_count growing steps cover it
};

struct RayHit {
  ivec2 texel;   // -1 unless ray_class is RAY_HIT, and so are p_px and t_m
  vec2 p_px;
  float t_m;
  int ray_class;
  int lookups;   // reads of the depth image or pyramid
  int steps;     // iterations of the march
};

RayHit ray_without_hit(int ray_class, int lookups, int steps) {
  return RayHit(ivec2(-1), vec2(-1.0), -1.0, ray_class, lookups, steps);
}

// The texel at p_px; positions that rounding puts on the image's outer edge belong to its last texel.
vec2 texel_at(vec2 p_px, TraceParameters parameters) { return clamp(floor(p_px), vec2(0.0), parameters.size_px - 1.0); }

// A hit's position, which rounding may put a little outside the image after the last step.
vec2 position_inside_px(vec2 p_px, TraceParameters parameters) { return clamp(p_px, vec2(0.0), parameters.size_px); }

// Far end of the column of a texel at dist_view: Z + T.
float column_far_m(float dist_view, TraceParameters parameters) {
  return dist_view + (parameters.thickness_rel * dist_view + parameters.thickness_m);
}

// Whether the ray's 1/dist_view interval, given by its two ends in any order, overlaps the column [Z, Z + T).
// Products instead of quotients: no division, and background, +inf times something positive, is no hit.
bool column_overlaps(float inv_dist_a, float inv_dist_b, float dist_view, TraceParameters parameters) {
  return min(inv_dist_a, inv_dist_b) * dist_view <= 1.0 &&
         max(inv_dist_a, inv_dist_b) * column_far_m(dist_view, parameters) > 1.0;
}

// Interleaved gradient noise in 0..1 (Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare",
// SIGGRAPH 2014 course), in ordered sums.
float dither_noise(vec2 p_px) {
  float phase = 0.06711056 * p_px.x + 0.00583715 * p_px.y;
  phase = 52.9829189 * (phase - floor(phase));
  return phase - floor(phase);
}

#endif
