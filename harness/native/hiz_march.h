// The Hi-Z march of shaders/include/ssr_march_hiz_tuned.glsl over as many rays as a vector has lanes,
// operation for operation, so that the bits are the shader's. Included once by the file of each instruction
// set.
#pragma once

#include "native/hiz_lanes.h"
#include "native/hiz_ray.h"

namespace ssrkit {
namespace {

constexpr int kClassHit = 2;
constexpr int kClassBudget = 5;
constexpr int kClassIntoSurface = 6;

struct Marched {
  Pair cell;
  Floats dist_view;  // of the cell hit
  Floats s_in;
  Floats s_out;
  Floats lookups;
  Mask is_hit;
  Mask is_over;
};

Floats columnFar(Floats dist_view, const HizScene& scene) {
  return dist_view + (scene.thickness_rel * dist_view + scene.thickness_m);
}

// Where the rays leave a cell, and whether by an edge that stands across x.
struct Exit {
  Floats s;
  Mask is_x;
};

Exit exitOf(const Rays& rays, const Pair& cell, Floats cell_size_px) {
  const Pair s = rays.sAtEdges((cell + rays.far_edge) * cell_size_px);
  return {stdx::min(s.x, s.y), s.x <= s.y};
}

Pair stepped(const Rays& rays, Pair cell, Mask is_x) {
  stdx::where(is_x, cell.x) += rays.direction.x;
  stdx::where(!is_x, cell.y) += rays.direction.y;
  return cell;
}

Pair childAt(const Rays& rays, const Pair& cell, Floats cell_size_px, Floats s) {
  const Pair s_middle = rays.sAtEdges((cell + Floats(0.5F)) * cell_size_px);
  Pair is_past{0.0F, 0.0F};
  stdx::where(s >= s_middle.x, is_past.x) = 1.0F;
  stdx::where(s >= s_middle.y, is_past.y) = 1.0F;
  return {2.0F * cell.x + stdx::abs((1.0F - rays.far_edge.x) - is_past.x),
          2.0F * cell.y + stdx::abs((1.0F - rays.far_edge.y) - is_past.y)};
}

// The next cell: down where a ray may hit, else along, and up where the parent is another one.
void move(const HizScene& scene, const Rays& rays, Mask may_hit, const Exit& exit, Mask active, Pair& cell,
          Floats& cell_size_px, Floats s_down) {
  const Pair child = childAt(rays, cell, cell_size_px, s_down);
  Pair along = stepped(rays, cell, exit.is_x);
  const Pair parent{stdx::floor(0.5F * along.x), stdx::floor(0.5F * along.y)};
  const Mask climbs = cell_size_px < scene.coarsest_px &&
                      (parent.x != stdx::floor(0.5F * cell.x) || parent.y != stdx::floor(0.5F * cell.y));
  stdx::where(climbs, along.x) = parent.x;
  stdx::where(climbs, along.y) = parent.y;
  stdx::where(active, cell.x) = chosen(may_hit, child.x, along.x);
  stdx::where(active, cell.y) = chosen(may_hit, child.y, along.y);
  const Floats along_size_px = chosen(climbs, 2.0F * cell_size_px, cell_size_px);
  stdx::where(active, cell_size_px) = chosen(may_hit, 0.5F * cell_size_px, along_size_px);
}

// Up to where the rays that go away come up to a depth; 0 or less for others (ssr_depth_reach.glsl).
struct DepthReach {
  Floats inv_dist_start;
  Floats s_per_inv_dist;

  [[nodiscard]] Floats sBefore(Floats dist_view) const {
    return (1.0F / dist_view - inv_dist_start) * s_per_inv_dist;
  }
};

DepthReach depthReach(const Rays& rays) {
  constexpr float kMargin = 1.0F / 65536.0F;
  constexpr float kLevelInvDistPerS = 1e-20F;
  return {rays.inv_dist_origin * (1.0F - kMargin),
          chosen(rays.inv_dist_per_s < -kLevelInvDistPerS, 1.0F / rays.inv_dist_per_s, 0.0F)};
}

Marched march(const HizScene& scene, const Rays& rays, Mask active) {
  Marched m{rays.origin_cell, 0.0F, 0.0F, 0.0F, 0.0F, Mask(false), Mask(false)};
  Floats cell_size_px = 1.0F;
  const Mask starts_own = active && m.cell.x == rays.own_texel.x && m.cell.y == rays.own_texel.y;
  const Exit first = exitOf(rays, m.cell, cell_size_px);
  stdx::where(starts_own, m.s_in) = first.s;
  m.is_over = starts_own && first.s >= rays.s_end;
  const Pair next = stepped(rays, m.cell, first.is_x);
  stdx::where(starts_own, m.cell.x) = next.x;
  stdx::where(starts_own, m.cell.y) = next.y;
  active = active && !m.is_over;
  m.s_out = m.s_in;
  const DepthReach reach = depthReach(rays);
  for (int lookups = 0; lookups < scene.lookup_budget && stdx::any_of(active); ++lookups) {
    const Exit exit = exitOf(rays, m.cell, cell_size_px);
    const Floats s_out = stdx::min(exit.s, rays.s_end);
    const Floats inv_dist_in = rays.invDist(m.s_in);
    const Floats inv_dist_out = rays.invDist(s_out);
    const Pair depths = loadPyramid(scene, m.cell, cell_size_px, active);
    stdx::where(active, m.lookups) += 1.0F;
    const Mask is_own = cell_size_px <= 1.0F && m.cell.x == rays.own_texel.x && m.cell.y == rays.own_texel.y;
    const Mask may_hit = stdx::min(inv_dist_in, inv_dist_out) * depths.x <= 1.0F &&
                         stdx::max(inv_dist_in, inv_dist_out) * columnFar(depths.y, scene) > 1.0F && !is_own;
    stdx::where(active, m.s_out) = s_out;
    stdx::where(active, m.dist_view) = depths.x;
    m.is_hit = m.is_hit || (active && may_hit && cell_size_px == 1.0F);
    m.is_over = m.is_over || (active && !may_hit && s_out >= rays.s_end);
    active = active && !m.is_hit && !m.is_over;
    const Floats s_down = stdx::max(m.s_in, reach.sBefore(depths.x));
    move(scene, rays, may_hit, exit, active, m.cell, cell_size_px, s_down);
    stdx::where(active, m.s_in) = chosen(may_hit, s_down, s_out);
  }
  return m;
}

// Where the rays enter the columns that they hit.
Floats hitS(const HizScene& scene, const Rays& rays, const Marched& m) {
  const Floats inv_dist_in = rays.invDist(m.s_in);
  const Floats far_m = columnFar(m.dist_view, scene);
  const Mask in_front = inv_dist_in * m.dist_view > 1.0F;
  const Mask behind = inv_dist_in * far_m <= 1.0F;
  const Floats inv_dist_hit = 1.0F / chosen(in_front, m.dist_view, far_m);
  const Floats s = (inv_dist_hit - rays.inv_dist_origin) / rays.inv_dist_per_s;
  return chosen(in_front || behind, stdx::min(stdx::max(s, m.s_in), m.s_out), m.s_in);
}

void traceLanes(const HizScene& scene, const int* texels, int count, HizAnswer* answers) {
  const Rays rays = reflectedRays(scene, texels, count);
  const Mask is_traced = rays.is_lane && !rays.into_surface && rays.s_end > 0.0F;
  const Marched m = march(scene, rays, is_traced);
  const Floats s = hitS(scene, rays, m);
  const Floats t_m = s / rays.invDist(s);
  for (int i = 0; i < count; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    const int lookups = static_cast<int>(m.lookups[lane]);
    HizAnswer& answer = answers[i];
    answer = {-1, -1, -1.0F, -1.0F, -1.0F, static_cast<int>(rays.end_class[lane]), lookups};
    if (rays.into_surface[lane]) {
      answer.ray_class = kClassIntoSurface;
    } else if (m.is_hit[lane]) {
      answer = {static_cast<int>(m.cell.x[lane]),
                static_cast<int>(m.cell.y[lane]),
                rays.origin_px.x[lane] + s[lane] * rays.px_per_s.x[lane],
                rays.origin_px.y[lane] + s[lane] * rays.px_per_s.y[lane],
                t_m[lane],
                kClassHit,
                lookups};
    } else if (is_traced[lane] && !m.is_over[lane]) {
      answer.ray_class = kClassBudget;
    }
  }
}

void traceTexels(const HizScene& scene, const int* texels, int count, HizAnswer* answers) {
  for (int first = 0; first < count; first += kLaneCount) {
    const int left = count - first;
    traceLanes(scene, texels + first, left < kLaneCount ? left : kLaneCount, answers + first);
  }
}

}  // namespace
}  // namespace ssrkit
