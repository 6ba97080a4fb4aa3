// The Hi-Z march, textbook form: a walk over the cells of a min-depth pyramid that takes the largest step that cannot
// miss anything (Uludag, "Hi-Z Screen-Space Cone-Traced Reflections", GPU Pro 5, chapter 4).
//
// In: a clipped ray. Out: the same texel as the exact walk; on a miss texel, p_px and t_m are -1.
// Needs: vec2 load_pyramid(vec2 cell, int mip)    x: least dist_view over the cell's texels, +inf when all are
//                                                 background; y: the greatest, background left out
// A cell of mip m covers the texels with texel >> m == cell, so sizes need not be powers of two.
//
// Three things make it exact where the published step is not. Cell edges are crossed at s values that come from one
// formula, so the next cell is the exact neighbour, with no nudge past the edge and no ray that sticks in a cell. The
// child to descend into is found by comparing s with the edge between the children, not by rounding a position. And the
// test is the ray's depth interval in the cell against the cell's depths, right for rays toward the camera too.
//
// It climbs where it leaves the cell's parent, by an edge that is the parent's too, not after every step: a parent that was
// just found to be in the way would only be looked at again. That is a fifth of the lookups. And it goes down into the
// child where the ray comes up to the cell's least depth, not into the first one: a tenth.
#ifndef SSR_MARCH_HIZ_GLSL
#define SSR_MARCH_HIZ_GLSL

#include "ssr_depth_reach.glsl"

// Of the four children of `cell`, the one that the ray is in at s; child_size_px is the children's.
vec2 hiz_child_at(Ray ray, vec2 cell, float child_size_px, vec2 far_edge, float s) {
  vec2 s_middle = ray_s_at_edges(ray, (2.0 * cell + 1.0) * child_size_px);
  vec2 is_past_middle = vec2(greaterThanEqual(vec2(s), s_middle));
  // Past the middle is the upper child for a ray that moves up, the lower one for a ray that moves down.
  return 2.0 * cell + abs((1.0 - far_edge) - is_past_middle);
}

RayHit march_hiz(Ray ray, TraceParameters parameters) {
  vec2 far_edge = ray_far_edge(ray);
  vec2 direction = 2.0 * far_edge - 1.0;
  vec2 cell = floor(ray.origin_px);
  int mip = 0;
  DepthReach reach = depth_reach(ray);
  float s_in = 0.0;
  float s_out = 0.0;
  vec2 cell_depths = vec2(0.0);
  int lookups = 0;
  int steps = 0;
  bool is_hit = false;
  bool is_over = false;
  for (; steps <= parameters.lookup_budget; ++steps) {
    float cell_size_px = exp2(float(mip));
    vec2 s_edges = ray_s_at_edges(ray, (cell + far_edge) * cell_size_px);
    s_out = ray_s_out(ray, s_edges);
    bool may_hit = false;
    if (mip > 0 || any(notEqual(cell, ray.own_texel))) {
      if (lookups == parameters.lookup_budget) {
        break;
      }
      cell_depths = load_pyramid(cell, mip);
      ++lookups;
      float inv_dist_in = ray_inv_dist(ray, s_in);
      float inv_dist_out = ray_inv_dist(ray, s_out);
      may_hit = min(inv_dist_in, inv_dist_out) * cell_depths.x <= 1.0 &&
                max(inv_dist_in, inv_dist_out) * column_far_m(cell_depths.y, parameters) > 1.0;
    }
    is_hit = may_hit && mip == 0;
    is_over = !may_hit && s_out >= ray.s_end;
    if (is_hit || is_over) {
      break;
    }
    if (may_hit) {
      s_in = s_on_to_depth(reach, s_in, cell_depths.x);
      cell = hiz_child_at(ray, cell, 0.5 * cell_size_px, far_edge, s_in);
      mip -= 1;
    } else {
      bool leaves_by_x = s_edges.x <= s_edges.y;
      float parents_at_edge = 0.5 * (leaves_by_x ? cell.x + far_edge.x : cell.y + far_edge.y);
      bool leaves_parent = floor(parents_at_edge) == parents_at_edge;
      cell += leaves_by_x ? vec2(direction.x, 0.0) : vec2(0.0, direction.y);
      s_in = s_out;
      if (leaves_parent && lookups > 0 && mip < parameters.max_mip) {
        cell = floor(0.5 * cell);
        mip += 1;
      }
    }
  }
  if (is_hit) {
    return ray_hit_in_texel(ray, cell, cell_depths.x, s_in, s_out, lookups, steps, parameters);
  }
  return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, steps);
}

#endif
