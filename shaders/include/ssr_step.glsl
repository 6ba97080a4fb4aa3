// Step length of the marches that go along the 3-D ray, in metres.
#ifndef SSR_STEP_GLSL
#define SSR_STEP_GLSL

#include "ssr_ray.glsl"

// The shortest step is a ray's length over this: the greatest step_count that there is.
const int MAX_STEP_COUNT = 16384;

// Iterations of a march, so that every ray comes to its end: jitter takes one step more, sums of steps and their growth
// round by some ten, and the iteration after the last step finds the end. Mesa cuts loops at 65,535 without a word.
const int MAX_MARCH_STEPS = MAX_STEP_COUNT + 64;

// How far a march keeps from a ray's vanishing point, in pixels: there the length in metres is infinite.
const float VANISHING_MARGIN_PX = 0.5;

// Length of the clipped ray. A ray that runs to its vanishing point inside the image ends half a pixel before it.
float ray_end_m(Ray ray) {
  float speed_px = max(abs(ray.px_per_s.x), abs(ray.px_per_s.y));
  float inv_dist_end = ray_inv_dist(ray, ray.s_end);
  float margin = VANISHING_MARGIN_PX / max(speed_px, PARALLEL_PX) * abs(ray.inv_dist_per_s);
  return ray.s_end / max(inv_dist_end, min(margin, ray.inv_dist_origin));
}

// The ray's end in s with the same margin.
float ray_end_s(Ray ray) {
  float s_margin = VANISHING_MARGIN_PX / max(max(abs(ray.px_per_s.x), abs(ray.px_per_s.y)), PARALLEL_PX);
  bool vanishes = ray_inv_dist(ray, ray.s_end) < s_margin * abs(ray.inv_dist_per_s);
  return vanishes ? max(ray.s_end - s_margin, 0.0) : ray.s_end;
}

// The user's step_m, or `otherwise_m` where there is none. A ray too long for so short steps takes longer ones: a march
// that ended halfway would have no answer.
float given_step_m(float t_end_m, float otherwise_m, TraceParameters parameters) {
  return parameters.step_m > 0.0 ? max(parameters.step_m, t_end_m / float(MAX_STEP_COUNT)) : otherwise_m;
}

// The user's step_m, or the clipped ray in step_count equal steps.
float march_step_m(float t_end_m, TraceParameters parameters) {
  return given_step_m(t_end_m, t_end_m / float(parameters.step_count), parameters);
}

// How far the samples of this pixel are moved back: up to jitter steps, by dither noise. In the unit of `step`.
float march_offset(Ray ray, float step, TraceParameters parameters) {
  return parameters.jitter * dither_noise(ray.own_texel + 0.5) * step;
}

#endif
