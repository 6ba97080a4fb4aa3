// Mutant of trace_adaptive.frag: the step grows, and never follows the depth difference.
#version 450
#include "trace_entry.glsl"
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
    step_m = max(base_step_m, parameters.step_growth * step_m);
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

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_adaptive(ray, trace_projection(), trace_parameters());
  }
  trace_end(hit);
}
