// The screen-space march in strides of several pixels: samples at equal distances on the image until one has passed
// behind a surface, then bisection_count one-sided bisections of the last stride.
//
// In: a clipped ray. Out: the texel at the far end of the last bracket; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// A sample answers for the stride before it: the ray's depth interval over that stride against the column at its end. So
// the bracket's far end is a hit from the beginning (an interval reaching half a stride further, right for one texel,
// would find the floor that a ray has just left), and n bisections leave 2^-n strides of it.
// What it gets wrong: what stands between two samples is not seen.
#ifndef SSR_MARCH_STRIDED_GLSL
#define SSR_MARCH_STRIDED_GLSL

#include "ssr_bisect.glsl"
#include "ssr_step.glsl"

// Looks at s_step, 2 s_step, ... and last at s_end, s_offset before each of them.
RayHit march_strided(Ray ray, float s_end, float s_step, float s_offset, float samples, TraceParameters parameters) {
  float s_front = 0.0;
  float s_behind = 0.0;
  float inv_dist_front = ray.inv_dist_origin;
  vec2 texel = ray.own_texel;
  int lookups = 0;
  bool is_hit = false;
  bool is_over = false;
  for (int i = 1; i <= MAX_MARCH_STEPS; ++i) {
    is_over = float(i) > samples;
    if (is_over || lookups >= parameters.lookup_budget) {
      break;
    }
    s_behind = min(float(i) * s_step - s_offset, s_end);
    texel = texel_at(ray_position_px(ray, s_behind), parameters);
    float inv_dist_behind = ray_inv_dist(ray, s_behind);
    float dist_view = load_dist_view(texel);
    ++lookups;
    is_hit = inv_dist_behind * dist_view <= 1.0 &&
             max(inv_dist_front, inv_dist_behind) * column_far_m(dist_view, parameters) > 1.0 &&
             any(notEqual(texel, ray.own_texel));
    if (is_hit) {
      break;
    }
    s_front = s_behind;
    inv_dist_front = inv_dist_behind;
  }
  if (!is_hit) {
    return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, lookups);
  }
  int bisections = min(parameters.bisection_count, parameters.lookup_budget - lookups);
  s_behind = bisect_s(ray, s_front, s_behind, bisections, texel, parameters);
  int all_lookups = lookups + max(bisections, 0);
  vec2 p_px = position_inside_px(ray_position_px(ray, s_behind), parameters);
  return RayHit(ivec2(texel), p_px, ray_t_m(ray, s_behind), RAY_HIT, all_lookups, all_lookups);
}

// stride_px pixels from sample to sample, along the ray's longer axis.
RayHit march_dda_strided(Ray ray, TraceParameters parameters) {
  float s_end = ray_end_s(ray);
  float s_step = parameters.stride_px / max(max(abs(ray.px_per_s.x), abs(ray.px_per_s.y)), PARALLEL_PX);
  float s_offset = march_offset(ray, s_step, parameters);
  return march_strided(ray, s_end, s_step, s_offset, ceil((s_end + s_offset) / s_step), parameters);
}

#endif
