// The Hi-Z march, tuned form: the textbook's answer (ssr_march_hiz.glsl), bit for bit, in less time.
//
// In: a clipped ray. Out: the same hit as the textbook form; on a miss texel, p_px and t_m are -1.
// Needs: vec2 load_atlas(vec2 cell, float cell_size_px)    least and greatest dist_view, as in the textbook form
//
// What differs, with what it is worth on software rasterisers (docs/performance.md): all levels stand in one texture,
// read with one fetch without a level per lane; no integers; the ray's first step, out of its own texel, and the hit
// point stand outside the loop, because what stands inside is paid for in every iteration by every lane. The read stands
// first: drivers call a function for it, around which all that is known already is saved and restored.
#ifndef SSR_MARCH_HIZ_TUNED_GLSL
#define SSR_MARCH_HIZ_TUNED_GLSL

#include "ssr_depth_reach.glsl"

RayHit march_hiz_tuned(Ray ray, TraceParameters parameters) {
  vec2 far_edge = ray_far_edge(ray);
  vec2 near_edge = 1.0 - far_edge;
  vec2 direction = far_edge - near_edge;
  float coarsest_px = exp2(float(parameters.max_mip));
  vec2 cell = floor(ray.origin_px);
  float cell_size_px = 1.0;
  float s_in = 0.0;
  if (all(equal(cell, ray.own_texel))) {
    vec2 s_edges = ray_s_at_edges(ray, cell + far_edge);
    s_in = min(s_edges.x, s_edges.y);
    if (s_in >= ray.s_end) {
      return ray_without_hit(ray.end_class, 0, 0);
    }
    cell += s_edges.x <= s_edges.y ? vec2(direction.x, 0.0) : vec2(0.0, direction.y);
  }
  DepthReach reach = depth_reach(ray);
  float s_out = s_in;
  vec2 cell_depths = vec2(0.0);
  int lookups = 0;
  bool is_hit = false;
  while (lookups < parameters.lookup_budget && s_in < ray.s_end) {
    cell_depths = load_atlas(cell, cell_size_px);
    ++lookups;
    vec2 s_edges = ray_s_at_edges(ray, (cell + far_edge) * cell_size_px);
    s_out = ray_s_out(ray, s_edges);
    float inv_dist_in = ray_inv_dist(ray, s_in);
    float inv_dist_out = ray_inv_dist(ray, s_out);
    bool may_hit = min(inv_dist_in, inv_dist_out) * cell_depths.x <= 1.0 &&
                   max(inv_dist_in, inv_dist_out) * column_far_m(cell_depths.y, parameters) > 1.0 &&
                   (cell_size_px > 1.0 || any(notEqual(cell, ray.own_texel)));
    is_hit = may_hit && cell_size_px == 1.0;
    if (is_hit) {
      break;
    }
    // Down: the child that the ray is in where it comes up to the cell's depth. Along: the neighbour, seen from one level
    // up where it has another parent.
    float s_down = s_on_to_depth(reach, s_in, cell_depths.x);
    vec2 s_middle = ray_s_at_edges(ray, (cell + 0.5) * cell_size_px);
    vec2 child = 2.0 * cell + vec2(s_down >= s_middle.x ? far_edge.x : near_edge.x,
                                   s_down >= s_middle.y ? far_edge.y : near_edge.y);
    bool leaves_by_x = s_edges.x <= s_edges.y;
    vec2 neighbour = cell + (leaves_by_x ? vec2(direction.x, 0.0) : vec2(0.0, direction.y));
    float parents_at_edge = 0.5 * (leaves_by_x ? cell.x + far_edge.x : cell.y + far_edge.y);
    bool climbs = cell_size_px < coarsest_px && floor(parents_at_edge) == parents_at_edge;
    vec2 parent = floor(0.5 * neighbour);
    cell = may_hit ? child : climbs ? parent : neighbour;
    cell_size_px = may_hit ? 0.5 * cell_size_px : climbs ? 2.0 * cell_size_px : cell_size_px;
    s_in = may_hit ? s_down : s_out;
  }
  if (is_hit) {
    return ray_hit_in_texel(ray, cell, cell_depths.x, s_in, s_out, lookups, lookups, parameters);
  }
  return ray_without_hit(s_in >= ray.s_end ? ray.end_class : RAY_BUDGET, lookups, lookups);
}

#endif
