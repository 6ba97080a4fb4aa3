// The coarse march with binary refinement: constant steps along the 3-D ray until a sample has passed behind a surface,
// then bisection_count one-sided bisections of the last step.
//
// In: a clipped ray. Out: the texel at the far end of the last bracket; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// The bracket [t_front_m, t_behind_m] halves each time: the residual is step * 2^-n. The bracket's far end is a hit at
// every moment, so refinement never loses one (a symmetric thickness window in the bisection would).
#ifndef SSR_MARCH_REFINED_GLSL
#define SSR_MARCH_REFINED_GLSL

#include "ssr_ray.glsl"
#include "ssr_step.glsl"

struct MarchSample {
  vec2 texel;
  vec2 p_px;
  float dist_ray;   // of the ray
  float dist_view;  // of the depth image there
};

MarchSample march_sample(Ray ray, float t_m, PixelProjection projection, TraceParameters parameters) {
  vec3 p_view = ray.origin_view + t_m * ray.dir_view;
  vec2 p_px = position_view_to_px(p_view, projection);
  vec2 texel = texel_at(p_px, parameters);
  return MarchSample(texel, p_px, -p_view.z, load_dist_view(texel));
}

RayHit march_refined(Ray ray, PixelProjection projection, TraceParameters parameters) {
  float t_end_m = ray_end_m(ray);
  float step_m = march_step_m(t_end_m, parameters);
  float t_offset_m = march_offset_m(ray, step_m, parameters);
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
    // The step's depth interval against the column: a step longer than the thickness does not jump over it.
    is_hit = behind.dist_ray >= behind.dist_view &&
             min(behind.dist_ray, dist_front) < column_far_m(behind.dist_view, parameters) &&
             any(notEqual(behind.texel, ray.own_texel));
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
  for (int i = 0; i < bisections; ++i) {
    float t_middle_m = 0.5 * (t_front_m + t_behind_m);
    MarchSample middle = march_sample(ray, t_middle_m, projection, parameters);
    bool is_behind = middle.dist_ray >= middle.dist_view && any(notEqual(middle.texel, ray.own_texel));
    t_front_m = is_behind ? t_front_m : t_middle_m;
    t_behind_m = is_behind ? t_middle_m : t_behind_m;
    if (is_behind) {
      behind = middle;
    }
  }
  int lookups = steps + max(bisections, 0);
  return RayHit(ivec2(behind.texel), behind.p_px, t_behind_m, RAY_HIT, lookups, lookups);
}

#endif
