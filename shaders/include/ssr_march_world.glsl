// The naive march in world space: the samples of ssr_march_naive.glsl, placed along the ray in world space and taken
// into view space one by one, as engines do that keep positions and normals in world space.
//
// In: a clipped ray, and the camera's matrix and its inverse, both rigid. Out: what the naive march gives, but for
//   rounding; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// What it gets wrong beside the naive march's own errors: single precision resolves 1e-7 of a world position, so the
// samples scatter by that much of the camera's distance from the world's origin (a millimetre at ten kilometres).
#ifndef SSR_MARCH_WORLD_GLSL
#define SSR_MARCH_WORLD_GLSL

#include "ssr_ray.glsl"
#include "ssr_step.glsl"

RayHit march_world(Ray ray, mat4 view_from_world, mat4 world_from_view, PixelProjection projection,
                   TraceParameters parameters) {
  vec4 origin_world = ordered_transform(world_from_view, vec4(ray.origin_view, 1.0));
  vec4 dir_world = ordered_transform(world_from_view, vec4(ray.dir_view, 0.0));
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
    vec3 p_view = vec3(ordered_transform(view_from_world, origin_world + t_m * dir_world));
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
