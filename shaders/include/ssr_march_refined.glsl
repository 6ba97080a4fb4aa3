// The coarse march with binary refinement: constant steps along the 3-D ray until a sample has passed behind a surface,
// then bisection_count one-sided bisections of the last step.
//
// In: a clipped ray. Out: the texel at the far end of the last bracket; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// The bracket [t_front_m, t_behind_m] halves each time: the residual is step * 2^-n.
#ifndef SSR_MARCH_REFINED_GLSL
#define SSR_MARCH_REFINED_GLSL

#include "ssr_sample.glsl"
#include "ssr_step.glsl"

RayHit march_refined(Ray ray, PixelProjection projection, TraceParameters parameters) {
  float t_end_m = ray_end_m(ray);
  float step_m = march_step_m(t_end_m, parameters);
  float t_offset_m = march_offset(ray, step_m, parameters);
  float t_front_m = 0.0;
  float t_behind_m = 0.0;
  float dist_front = -ray.origin_view.z;
  MarchSample behind;
  int steps = 0;
  bool is_hit = false;
  bool is_over = false;
  for (int i = 1; i <= MAX_MARCH_STEPS; ++i) {
    is_over = t_front_m >= t_end_m;
    if (is_over || steps >= parameters.lookup_budget) {
      break;
    }
    // The last step may be shorter than the others: the ray's end is sampled too.
    t_behind_m = min(float(i) * step_m - t_offset_m, t_end_m);
    behind = march_sample(ray, t_behind_m, projection, parameters);
    ++steps;
    is_hit = step_hits(ray, behind, dist_front, parameters);
    if (is_hit) {
      break;
    }
    t_front_m = t_behind_m;
    dist_front = behind.dist_ray;
  }
  if (!is_hit) {
    return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, steps, steps);
  }
  int bisections = min(parameters.bisection_count, parameters.lookup_budget - steps);
  t_behind_m = bisect_t(ray, t_front_m, t_behind_m, bisections, behind, projection, parameters);
  int lookups = steps + max(bisections, 0);
  vec2 p_px = position_inside_px(behind.p_px, parameters);
  return RayHit(ivec2(behind.texel), p_px, t_behind_m, RAY_HIT, lookups, lookups);
}

#endif
