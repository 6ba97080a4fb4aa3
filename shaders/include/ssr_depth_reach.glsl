// How far a ray goes before it comes up to a given depth: up to there nothing that is no nearer can be in its way.
//
// Only for rays that go away from the camera; others reach no depth and get s = 0. It is the published step's
// intersection with the cell's depth plane (Uludag, GPU Pro 5, chapter 4), kept on the near side of the plane: rounding
// moves s by a few 2^-24 of the origin's 1 / dist_view over its slope, the margin takes off 2^-16 of it. So the ray is still
// in front at s by the march's own test, and a march that goes on from s hits what one that did not skip hits, bit for bit.
#ifndef SSR_DEPTH_REACH_GLSL
#define SSR_DEPTH_REACH_GLSL

#include "ssr_ray.glsl"

const float DEPTH_REACH_MARGIN = 1.0 / 65536.0;
const float LEVEL_INV_DIST_PER_S = 1e-20;  // slower than this a ray keeps its depth, and 1 / it stays finite

struct DepthReach {
  float inv_dist_start;
  float s_per_inv_dist;  // 0 for rays that do not go away
};

DepthReach depth_reach(Ray ray) {
  float s_per_inv_dist = ray.inv_dist_per_s < -LEVEL_INV_DIST_PER_S ? 1.0 / ray.inv_dist_per_s : 0.0;
  return DepthReach(ray.inv_dist_origin * (1.0 - DEPTH_REACH_MARGIN), s_per_inv_dist);
}

// From s on to where the ray comes up to that depth; s itself where it is there already. Compared by their bits, as in
// ray_s_out(): only one of the two can be negative.
float s_on_to_depth(DepthReach reach, float s, float dist_view) {
  float s_depth = (1.0 / dist_view - reach.inv_dist_start) * reach.s_per_inv_dist;
  return intBitsToFloat(max(floatBitsToInt(s), floatBitsToInt(s_depth)));
}

#endif
