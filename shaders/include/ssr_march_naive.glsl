// The naive march: constant steps along the 3-D ray in view space, one depth test at each sample.
//
// In: a clipped ray. Out: the texel of the first sample that lies inside a column; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// What it gets wrong: near the camera one step jumps over many texels, and over everything thinner than a step; far from
// it many samples fall into one texel. Its answer approaches the exact walk's as the step shrinks, and its cost grows as
// 1 / step.
#ifndef SSR_MARCH_NAIVE_GLSL
#define SSR_MARCH_NAIVE_GLSL

#include "ssr_ray.glsl"
#include "ssr_step.glsl"

RayHit march_naive(Ray ray, PixelProjection projection, TraceParameters parameters) {
  float t_end_m = ray_end_m(ray);
  float step_m = march_step_m(t_end_m, parameters);
  float t_offset_m = march_offset(ray, step_m, parameters);
  float t_m = 0.0;
  vec2 p_px = ray.origin_px;
  int lookups = 0;
  int steps = 0;
  bool is_hit = false;
  bool is_over = false;
  for (int i = 1; i <= MAX_MARCH_STEPS; ++i) {
    t_m = float(i) * step_m - t_offset_m;
    is_over = t_m >= t_end_m;
    if (is_over || lookups >= parameters.lookup_budget) {
      break;
    }
    ++steps;
    vec3 p_view = ray.origin_view + t_m * ray.dir_view;
    p_px = position_view_to_px(p_view, projection);
    vec2 texel = texel_at(p_px, parameters);
    if (any(notEqual(texel, ray.own_texel))) {
      ++lookups;
      float dist_view = load_dist_view(texel);
      is_hit = -p_view.z >= dist_view && -p_view.z < column_far_m(dist_view, parameters);
    }
    if (is_hit) {
      break;
    }
  }
  if (is_hit) {
    return RayHit(ivec2(texel_at(p_px, parameters)), position_inside_px(p_px, parameters), t_m, RAY_HIT, lookups,
                  steps);
  }
  return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, steps);
}

#endif
