// The march whose step follows the depth difference: as long as the ray is in front of the surface that it sees, by so
// much may the next step be longer; then bisection_count one-sided bisections of the last step.
//
// In: a clipped ray. Out: the texel at the far end of the last bracket; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// The step is the difference Z - dist_ray at the last sample, no shorter than the base step and at most step_growth times
// the step before. A step of t metres changes dist_view by at most t, so a surface that faces the camera is never
// overshot (the argument of sphere tracing: Hart, "Sphere Tracing", The Visual Computer 12, 1996); behind a surface, and
// close to one, steps have the base length.
// What it gets wrong: one texel's depth says nothing of its neighbours. A thin thing before a far wall is jumped over by
// a step that the wall allowed.
#ifndef SSR_MARCH_ADAPTIVE_GLSL
#define SSR_MARCH_ADAPTIVE_GLSL

#include "ssr_sample.glsl"
#include "ssr_step.glsl"

RayHit march_adaptive(Ray ray, PixelProjection projection, TraceParameters parameters) {
  float t_end_m = ray_end_m(ray);
  float base_step_m = march_step_m(t_end_m, parameters);
  float step_m = base_step_m - march_offset(ray, base_step_m, parameters);
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
    // A rest of a thousandth of a step is the sum's rounding.
    t_behind_m = t_front_m + 1.001 * step_m < t_end_m ? t_front_m + step_m : t_end_m;
    behind = march_sample(ray, t_behind_m, projection, parameters);
    ++steps;
    is_hit = step_hits(ray, behind, dist_front, parameters);
    if (is_hit) {
      break;
    }
    step_m = max(base_step_m, min(behind.dist_view - behind.dist_ray, parameters.step_growth * step_m));
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
