// The reflected rays of shaders/include/ssr_ray.glsl, one a lane, operation for operation.
#pragma once

#include "native/hiz_lanes.h"

namespace ssrkit {
namespace {

constexpr float kFarS = 1e30F;
constexpr float kFarthestInvDist = 1e-20F;
constexpr float kParallelPx = 1e-20F;
constexpr float kClassOffscreen = 3.0F;
constexpr float kClassRange = 4.0F;

struct Rays {
  Mask is_lane{false};  // the last lanes may have no texel
  Mask into_surface{false};
  Pair own_texel;
  Pair origin_px;
  Pair origin_cell;
  Pair px_per_s;
  Pair s_per_px;
  Pair far_edge;
  Pair direction;
  Floats inv_dist_origin;
  Floats inv_dist_per_s;
  Floats s_end;
  Floats end_class;  // the contract's codes

  [[nodiscard]] Floats invDist(Floats s) const {
    return stdx::max(inv_dist_origin + s * inv_dist_per_s, Floats(kFarthestInvDist));
  }
  [[nodiscard]] Pair sAtEdges(const Pair& edge_px) const {
    return {(edge_px.x - origin_px.x) * s_per_px.x, (edge_px.y - origin_px.y) * s_per_px.y};
  }
};

struct Surface {
  Pair p_px;
  Floats dist_view;
  Triple normal;
  Floats clearance;
};

inline Surface loadSurfaces(const HizScene& scene, const int* texels, int count) {
  const auto texel = [&](auto lane) {
    const int i = static_cast<int>(lane);
    return texels[i < count ? i : 0];
  };
  const auto normal = [&](int channel) {
    return Floats([&](auto lane) {
      return scene.normal_view[static_cast<std::ptrdiff_t>(texel(lane)) * scene.normal_channels + channel];
    });
  };
  Surface surface{{Floats([&](auto lane) { return static_cast<float>(texel(lane) % scene.width) + 0.5F; }),
                   Floats([&](auto lane) {
                     const int row = texel(lane) / scene.width;
                     return static_cast<float>(row) + 0.5F;
                   })},
                  Floats([&](auto lane) { return scene.dist_view[texel(lane)]; }),
                  orderedNormalize({normal(0), normal(1), normal(2)}),
                  0.0F};
  if (scene.normal_channels > 3) {
    surface.clearance = normal(3);
  }
  return surface;
}

inline Floats farEdge(Floats px_per_s) {
  return chosen(px_per_s >= -kParallelPx, 1.0F, 0.0F);
}

inline Floats sPerPx(Floats px_per_s) {
  return chosen(stdx::abs(px_per_s) > kParallelPx, 1.0F / px_per_s, kFarS);
}

inline void clip(const HizScene& scene, const Triple& origin, const Triple& dir, Rays& rays) {
  const Pair size{static_cast<float>(scene.width), static_cast<float>(scene.height)};
  const Pair s_edges = rays.sAtEdges({rays.far_edge.x * size.x, rays.far_edge.y * size.y});
  const Floats dist_origin = -origin.z;
  const Floats dist_per_m = -dir.z;
  Floats s_offscreen = stdx::min(s_edges.x, s_edges.y);
  const Floats s_near = (dist_origin - scene.near_m) / (scene.near_m * -dist_per_m);
  stdx::where(dist_per_m < 0.0F, s_offscreen) = stdx::min(s_offscreen, s_near);
  const Floats dist_at_range = dist_origin + scene.max_distance_m * dist_per_m;
  const Floats s_range = chosen(dist_at_range > 0.0F, scene.max_distance_m / dist_at_range, kFarS);
  rays.s_end = stdx::min(s_offscreen, s_range);
  rays.end_class = kClassOffscreen;
  stdx::where(s_range < s_offscreen, rays.end_class) = kClassRange;
  const Mask starts_outside = dist_origin < scene.near_m || rays.origin_px.x < 0.0F ||
                              rays.origin_px.y < 0.0F || rays.origin_px.x >= size.x ||
                              rays.origin_px.y >= size.y;
  stdx::where(starts_outside, rays.s_end) = 0.0F;
  stdx::where(starts_outside, rays.end_class) = kClassOffscreen;
}

inline Rays reflectedRays(const HizScene& scene, const int* texels, int count) {
  const Surface at = loadSurfaces(scene, texels, count);
  const Triple p_view{at.dist_view * ((at.p_px.x - scene.px_offset[0]) * scene.view_per_px[0]),
                      at.dist_view * ((at.p_px.y - scene.px_offset[1]) * scene.view_per_px[1]),
                      -at.dist_view};
  const Triple incident = orderedNormalize(p_view);
  const Floats twice = 2.0F * orderedDot(at.normal, incident);
  const Triple dir{incident.x - twice * at.normal.x, incident.y - twice * at.normal.y,
                   incident.z - twice * at.normal.z};
  const Floats bias_m = scene.origin_bias * at.dist_view;
  const Triple origin{p_view.x + bias_m * at.normal.x, p_view.y + bias_m * at.normal.y,
                      p_view.z + bias_m * at.normal.z};
  Rays rays;
  rays.is_lane = Mask(Floats([](auto lane) { return static_cast<float>(lane); }) < static_cast<float>(count));
  rays.own_texel = {stdx::floor(at.p_px.x), stdx::floor(at.p_px.y)};
  rays.origin_px = at.p_px;
  if (scene.origin_bias > 0.0F) {
    rays.origin_px = {scene.px_scale[0] * (origin.x / -origin.z) + scene.px_offset[0],
                      scene.px_scale[1] * (origin.y / -origin.z) + scene.px_offset[1]};
  }
  rays.origin_cell = {stdx::floor(rays.origin_px.x), stdx::floor(rays.origin_px.y)};
  rays.inv_dist_origin = 1.0F / -origin.z;
  rays.inv_dist_per_s = dir.z * rays.inv_dist_origin;
  rays.px_per_s = {
      (at.p_px.x - rays.origin_px.x) * -incident.z -
          twice * (scene.px_scale[0] * at.normal.x - (scene.px_offset[0] - rays.origin_px.x) * at.normal.z),
      (at.p_px.y - rays.origin_px.y) * -incident.z -
          twice * (scene.px_scale[1] * at.normal.y - (scene.px_offset[1] - rays.origin_px.y) * at.normal.z)};
  rays.s_per_px = {sPerPx(rays.px_per_s.x), sPerPx(rays.px_per_s.y)};
  rays.far_edge = {farEdge(rays.px_per_s.x), farEdge(rays.px_per_s.y)};
  rays.direction = {2.0F * rays.far_edge.x - 1.0F, 2.0F * rays.far_edge.y - 1.0F};
  clip(scene, origin, dir, rays);
  rays.into_surface = orderedDot(dir, at.normal) < 0.0F || at.clearance < 0.0F;
  return rays;
}

}  // namespace
}  // namespace ssrkit
