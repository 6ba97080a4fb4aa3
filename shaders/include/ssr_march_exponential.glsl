// The march with growing steps: each is step_growth times as long as the one before, until a sample has passed behind a
// surface; then bisection_count one-sided bisections of the last step.
//
// In: a clipped ray. Out: the texel at the far end of the last bracket; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// The first step is first_step_share of the ray, (g - 1) / (g^n - 1) for n steps that grow by g: they end where the ray
// ends. Steps are short where the ray starts and long where it ends: right for a ray that goes away from the camera, near
// which a metre is most texels.
// What it gets wrong: the length grows with the number of the step, not with what a step is worth on the image. On a ray
// that comes towards the camera the longest steps fall where the image is finest.
#ifndef SSR_MARCH_EXPONENTIAL_GLSL
#define SSR_MARCH_EXPONENTIAL_GLSL

#include "ssr_sample.glsl"
#include "ssr_step.glsl"

RayHit march_exponential(Ray ray, PixelProjection projection, TraceParameters parameters) {
  float t_end_m = ray_end_m(ray);
  float step_m = given_step_m(t_end_m, parameters.first_step_share * t_end_m, parameters);
  float offset_steps = march_offset(ray, 1.0, parameters);
  float t_next_m = 0.0;
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
    t_next_m += step_m;
    // The last step may be shorter than it would be: the ray's end is sampled too. A rest of a thousandth of a step is
    // the sum's rounding.
    t_behind_m = t_next_m - offset_steps * step_m;
    t_behind_m = t_behind_m + 0.001 * step_m < t_end_m ? t_behind_m : t_end_m;
    step_m *= parameters.step_growth;
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
