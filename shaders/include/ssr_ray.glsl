// The reflected ray of a pixel, and its straight line on the image.
//
// With w(t) = dist_view of the ray at t metres, let s = t / w(t). Then position and inverse depth are both linear in s:
//   p_px(s) = origin_px + s * px_per_s        1 / dist_view(s) = inv_dist_origin + s * inv_dist_per_s
// so a march along s is perspective-correct, needs no end point (none can lie behind the camera), no division in the
// loop, and starts exactly at the texel's centre. (The same identity as interpolating Q/w and 1/w in McGuire and Mara,
// "Efficient GPU Screen-Space Ray Tracing", JCGT 3(4) 2014, section 3, with s in the place of the segment's fraction.)
#ifndef SSR_RAY_GLSL
#define SSR_RAY_GLSL

#include "ssr_contract.glsl"
#include "ssr_spaces.glsl"

const float FAR_S = 1e30;         // later than every end of a ray
const float FARTHEST_INV_DIST = 1e-20;
const float PARALLEL_PX = 1e-20;  // px_per_s below this does not move: 1 / 1e-20 times any image size stays finite

struct Ray {
  vec2 own_texel;        // the pixel's own texel is never tested
  vec3 origin_view;
  vec3 dir_view;         // unit
  vec2 origin_px;
  vec2 px_per_s;
  vec2 s_per_px;         // 1 / px_per_s, or FAR_S along an axis on which the ray stands still
  float inv_dist_origin;
  float inv_dist_per_s;
  float s_end;           // the ray is 0 <= s < s_end
  int end_class;         // RAY_OFFSCREEN or RAY_RANGE: what ends it there
};

vec2 ray_position_px(Ray ray, float s) { return ray.origin_px + s * ray.px_per_s; }

// Never zero or negative, as rounding would have it at the vanishing point: a negative product with a background's
// infinite distance would look like a hit, and zero times infinity is no number.
float ray_inv_dist(Ray ray, float s) { return max(ray.inv_dist_origin + s * ray.inv_dist_per_s, FARTHEST_INV_DIST); }

float ray_t_m(Ray ray, float s) { return s / ray_inv_dist(ray, s); }

// s at which the ray crosses the lines x = edge_px.x and y = edge_px.y. Every march uses this one formula for every
// edge of every cell and of the image, so that the same edge always gives the same bits.
vec2 ray_s_at_edges(Ray ray, vec2 edge_px) { return (edge_px - ray.origin_px) * ray.s_per_px; }

// 1 towards larger coordinates (also where the ray stands still), else 0: the far edge of a cell is cell + this.
vec2 ray_far_edge(Ray ray) { return vec2(ray.px_per_s.x >= -PARALLEL_PX, ray.px_per_s.y >= -PARALLEL_PX); }

// s at which the ray leaves a cell, or ends: the least of s_edges, where it crosses the cell's edges ahead, and s_end.
// By their bits, which are ordered as the numbers are where none is negative: min() of floats minds what is no number, which
// on software rasterisers is two more instructions, in the chain that the march's next step waits for.
float ray_s_out(Ray ray, vec2 s_edges) {
  ivec2 edges = floatBitsToInt(s_edges);
  return intBitsToFloat(min(min(edges.x, edges.y), floatBitsToInt(ray.s_end)));
}

// Sets s_end and end_class: the nearest of the image's edges, the near plane and max_distance_m.
void ray_clip(inout Ray ray, TraceParameters parameters) {
  vec2 s_edges = ray_s_at_edges(ray, ray_far_edge(ray) * parameters.size_px);
  float dist_origin = -ray.origin_view.z;
  float dist_per_m = -ray.dir_view.z;
  float s_offscreen = min(s_edges.x, s_edges.y);
  if (dist_per_m < 0.0) {
    s_offscreen = min(s_offscreen, (dist_origin - parameters.near_m) / (parameters.near_m * -dist_per_m));
  }
  float dist_at_range = dist_origin + parameters.max_distance_m * dist_per_m;
  float s_range = dist_at_range > 0.0 ? parameters.max_distance_m / dist_at_range : FAR_S;
  ray.s_end = min(s_offscreen, s_range);
  ray.end_class = s_range < s_offscreen ? RAY_RANGE : RAY_OFFSCREEN;
}

// The ray of the texel with centre p_px, dist_view and unit normal_view, reflected and clipped.
// An origin that the bias moved out of the image or before the near plane gives s_end <= 0.
Ray ray_reflected(vec2 p_px, float dist_view, vec3 normal_view, PixelProjection projection,
                  TraceParameters parameters) {
  vec3 p_view = position_px_to_view(p_px, dist_view, projection);
  vec3 incident_view = ordered_normalize(p_view);
  float normal_times_incident = ordered_dot(normal_view, incident_view);
  Ray ray;
  ray.own_texel = floor(p_px);
  ray.dir_view = incident_view - (2.0 * normal_times_incident) * normal_view;
  float bias_m = parameters.origin_bias * dist_view;
  ray.origin_view = p_view + bias_m * normal_view;
  ray.origin_px = parameters.origin_bias > 0.0 ? position_view_to_px(ray.origin_view, projection) : p_px;
  ray.inv_dist_origin = 1.0 / -ray.origin_view.z;
  ray.inv_dist_per_s = ray.dir_view.z * ray.inv_dist_origin;
  // px_per_s is linear in the direction, px_scale * dir.xy + (px_offset - origin_px) * -dir.z, and the incident
  // direction projects onto the pixel itself: only the normal's share moves the ray. Leaving the incident share out
  // where it cancels keeps a column of rays over a level floor exactly vertical.
  vec2 normal_share = projection.px_scale * normal_view.xy - (projection.px_offset - ray.origin_px) * normal_view.z;
  vec2 incident_share = (p_px - ray.origin_px) * -incident_view.z;
  ray.px_per_s = incident_share - (2.0 * normal_times_incident) * normal_share;
  ray.s_per_px = vec2(abs(ray.px_per_s.x) > PARALLEL_PX ? 1.0 / ray.px_per_s.x : FAR_S,
                      abs(ray.px_per_s.y) > PARALLEL_PX ? 1.0 / ray.px_per_s.y : FAR_S);
  ray_clip(ray, parameters);
  bool starts_outside = -ray.origin_view.z < parameters.near_m || any(lessThan(ray.origin_px, vec2(0.0))) ||
                        any(greaterThanEqual(ray.origin_px, parameters.size_px));
  if (starts_outside) {
    ray.s_end = 0.0;
    ray.end_class = RAY_OFFSCREEN;
  }
  return ray;
}

// The hit record of a texel that the ray overlaps between s_in and s_out: the point is where the ray enters the
// overlap, so at s_in, or where dist_view comes up to Z from the front or down to Z + T from behind.
RayHit ray_hit_in_texel(Ray ray, vec2 texel, float dist_view, float s_in, float s_out, int lookups, int steps,
                        TraceParameters parameters) {
  float inv_dist_in = ray_inv_dist(ray, s_in);
  float far_m = column_far_m(dist_view, parameters);
  bool in_front = inv_dist_in * dist_view > 1.0;
  bool behind = inv_dist_in * far_m <= 1.0;
  float s = s_in;
  if (in_front || behind) {
    float inv_dist_hit = 1.0 / (in_front ? dist_view : far_m);
    s = clamp((inv_dist_hit - ray.inv_dist_origin) / ray.inv_dist_per_s, s_in, s_out);
  }
  return RayHit(ivec2(texel), ray_position_px(ray, s), ray_t_m(ray, s), RAY_HIT, lookups, steps);
}

#endif
