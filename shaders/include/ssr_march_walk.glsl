// The exact walk: every cell that the ray crosses, in order (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for
// Ray Tracing", Eurographics 1987, in two dimensions).
//
// In: a clipped ray. Out: the first texel whose column the ray overlaps; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// Cost: one lookup a cell, the pixel's own excepted. It is the yardstick of equal quality for the other tracers.
#ifndef SSR_MARCH_WALK_GLSL
#define SSR_MARCH_WALK_GLSL

#include "ssr_ray.glsl"

RayHit march_walk(Ray ray, TraceParameters parameters) {
  vec2 far_edge = ray_far_edge(ray);
  vec2 direction = 2.0 * far_edge - 1.0;
  vec2 cell = floor(ray.origin_px);
  float s_in = 0.0;
  vec2 s_edges = ray_s_at_edges(ray, cell + far_edge);
  float dist_view = 0.0;
  float s_out = 0.0;
  float inv_dist_in = ray.inv_dist_origin;
  int lookups = 0;
  bool is_hit = false;
  bool is_over = false;
  // The origin's cell first: it is the pixel's own unless the bias moved the origin.
  bool is_own = all(equal(cell, ray.own_texel));
  for (int step = 0; step <= parameters.lookup_budget; ++step) {
    s_out = ray_s_out(ray, s_edges);
    float inv_dist_out = ray_inv_dist(ray, s_out);
    if (!is_own) {
      if (lookups == parameters.lookup_budget) {
        break;
      }
      dist_view = load_dist_view(cell);
      ++lookups;
      is_hit = column_overlaps(inv_dist_in, inv_dist_out, dist_view, parameters);
    }
    is_over = s_out >= ray.s_end;
    if (is_hit || is_over) {
      break;
    }
    // Into the neighbour across the nearer edge.
    cell += s_edges.x <= s_edges.y ? vec2(direction.x, 0.0) : vec2(0.0, direction.y);
    s_edges = ray_s_at_edges(ray, cell + far_edge);
    s_in = s_out;
    inv_dist_in = inv_dist_out;
    is_own = all(equal(cell, ray.own_texel));
  }
  if (is_hit) {
    return ray_hit_in_texel(ray, cell, dist_view, s_in, s_out, lookups, lookups, parameters);
  }
  return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, lookups);
}

#endif
