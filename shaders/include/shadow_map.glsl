// Visibility of a directional light from a shadow map in cascades.
//
// Light space: metres, right-handed, z along the light's way, origin that of the world; x and y grow as the map's
//   columns and rows do, so nothing is flipped. A cascade is a square of the map: xy of its first texel's corner in
//   metres, then metres a texel, then its inverse. The map's depth is (z - near_m) / range_m.
// Percentage-closer filtering over 3 x 3 texels (Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth
//   Maps", SIGGRAPH 1987): the share of the square of 3 x 3 texels about the point, edges counted by the part of them
//   that the square covers, whose stored depth is not before the receiver.
// The receiver is a plane, not a point: each texel is compared with the depth that the receiver's plane has there
//   (Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", GDC 2006), so a lit plane needs no bias for its slope.
//   What is left is what its normal may be wrong by, as between two facets of a sphere, at the filter's farthest texel:
//     bias_m = texel_m * reach * error / max(cosine^2, 1/32) + range_m * 2^-20 * (1 + |slope|)
//   reach: 2 sqrt 2 texels. error: 3/16 rad, the facets of a sphere of 48 across both axes. 1 / cosine^2: how fast
//   the slope, a tangent, grows with the angle; bounded, as a surface that the light grazes is dark anyway. 2^-20:
//   single precision.
// Needs: float load_shadow_depth(vec2 texel) over the whole atlas, cascades side by side.
// In: light-space position, slope of the receiver's plane and its cosine. Out: 0 to 1. A surface that the light does
//   not reach from its front, or meets within 1.1 degrees of its plane (SHADOW_MIN_COSINE), is in its own shadow: 0.
//   Outside all cascades: 1.
#ifndef SHADOW_MAP_GLSL
#define SHADOW_MAP_GLSL

#include "ssr_ordered.glsl"

const float SHADOW_MIN_COSINE = 0.02;
const float SHADOW_FILTER_RADIUS = 1.5;  // texels
const float SHADOW_FILTER_REACH = 2.83;  // texels from the point to the farthest texel's centre
const float SHADOW_NORMAL_ERROR = 0.1875;
const float SHADOW_MAX_TILT = 32.0;  // of 1 / cosine^2
const float SHADOW_DEPTH_ERROR = 1.0 / 1048576.0;

// The cascades are no array: Mesa's software drivers keep one in memory, which takes a sixth of the pass's time.
struct ShadowMap {
  vec4 finest;  // cascades; zeros where there is none
  vec4 second;
  vec4 third;
  vec4 fourth;
  float side_texels;  // of a cascade
  float near_m;
  float range_m;
};

vec2 shadow_map_px(vec3 p_light, vec4 cascade) { return (p_light.xy - cascade.xy) * cascade.w; }

float shadow_depth(float z_light, ShadowMap map) { return (z_light - map.near_m) / map.range_m; }

struct ShadowCascade {
  vec4 square;
  float first_column;  // in the atlas, texels
  bool is_found;
};

// The finest cascade whose square holds all texels that the filter reads: from the coarsest on, each that does takes the
// place of the one before.
ShadowCascade finer_where_it_holds(ShadowCascade found, vec3 p_light, vec4 square, float first_column, ShadowMap map) {
  vec2 px = shadow_map_px(p_light, square);
  vec2 to_edge = min(px, map.side_texels - px);
  bool holds = min(to_edge.x, to_edge.y) >= SHADOW_FILTER_RADIUS + 0.5;
  return ShadowCascade(holds ? square : found.square, holds ? first_column : found.first_column,
                       holds || found.is_found);
}

ShadowCascade shadow_cascade_at(vec3 p_light, ShadowMap map) {
  ShadowCascade found = ShadowCascade(map.finest, 0.0, false);
  found = finer_where_it_holds(found, p_light, map.fourth, 3.0 * map.side_texels, map);
  found = finer_where_it_holds(found, p_light, map.third, 2.0 * map.side_texels, map);
  found = finer_where_it_holds(found, p_light, map.second, map.side_texels, map);
  return finer_where_it_holds(found, p_light, map.finest, 0.0, map);
}

// Four texels of one row, weighted by how much of them the filter's square covers; the receiver's depth at the first of
// them, and how much it grows to the next.
float shadow_row(vec2 texel, float depth, float depth_per_texel, vec2 edge_weights) {
  vec4 stored = vec4(load_shadow_depth(texel), load_shadow_depth(texel + vec2(1.0, 0.0)),
                     load_shadow_depth(texel + vec2(2.0, 0.0)), load_shadow_depth(texel + vec2(3.0, 0.0)));
  // Never past the far end: beyond the rim of a slanted plane its continuation may lie there, where nothing is.
  vec4 receiver = min(depth + depth_per_texel * vec4(0.0, 1.0, 2.0, 3.0), vec4(1.0));
  vec4 is_lit = vec4(greaterThanEqual(stored, receiver));
  return (is_lit.y + is_lit.z) + (is_lit.x * edge_weights.x + is_lit.w * edge_weights.y);
}

float shadow_bias_m(vec2 slope, float cosine, float texel_m, ShadowMap map) {
  float tilt = min(1.0 / (cosine * cosine), SHADOW_MAX_TILT);
  float steepness = abs(slope.x) + abs(slope.y);
  return texel_m * (SHADOW_FILTER_REACH * SHADOW_NORMAL_ERROR) * tilt +
         map.range_m * SHADOW_DEPTH_ERROR * (1.0 + steepness);
}

// dz/dx and dz/dy of a surface with this normal.
vec2 shadow_slope(vec3 normal_light) { return normal_light.xy / max(-normal_light.z, SHADOW_MIN_COSINE); }

float shadow_visibility(vec3 p_light, vec2 slope, float cosine, ShadowMap map) {
  ShadowCascade found = shadow_cascade_at(p_light, map);
  vec4 cascade = found.square;
  vec2 corner = shadow_map_px(p_light, cascade) - SHADOW_FILTER_RADIUS;
  vec2 first = floor(corner);
  vec2 cut_off = corner - first;  // the part of the first texel outside the square, and of the last one inside it
  vec2 first_offset_m = ((first + 0.5) - (corner + SHADOW_FILTER_RADIUS)) * cascade.z;
  float z_first = (p_light.z - shadow_bias_m(slope, cosine, cascade.z, map)) + ordered_dot(slope, first_offset_m);
  float depth = shadow_depth(z_first, map);
  vec2 step_depth = slope * (cascade.z / map.range_m);
  vec2 texel = first + vec2(found.first_column, 0.0);
  vec2 edges = vec2(1.0 - cut_off.x, cut_off.x);
  vec2 down = vec2(0.0, 1.0);
  float lit_texels = shadow_row(texel, depth, step_depth.x, edges) * (1.0 - cut_off.y);
  lit_texels += shadow_row(texel + down, depth + step_depth.y, step_depth.x, edges);
  lit_texels += shadow_row(texel + 2.0 * down, depth + 2.0 * step_depth.y, step_depth.x, edges);
  lit_texels += shadow_row(texel + 3.0 * down, depth + 3.0 * step_depth.y, step_depth.x, edges) * cut_off.y;
  float share = lit_texels / (4.0 * SHADOW_FILTER_RADIUS * SHADOW_FILTER_RADIUS);
  // The weights' sum is 9 up to rounding: all lit is 1 and not a little beside it.
  float visibility = share > 1.0 - 1e-5 || !found.is_found ? 1.0 : share;
  return cosine <= SHADOW_MIN_COSINE ? 0.0 : visibility;
}

#endif
