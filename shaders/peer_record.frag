// A peer's answer as the kit's ray record.
//
// In:  peer_answer, dist_view, normal_view, material. Out: hit_texel, hit_point, ray_work. Where the peer says that it
//      missed, the class is that of the ray's end: a peer has no word for it. Its distance along the ray is not known: 0.
//      Where the kit traces no ray, nor one into its surface, what the peer says counts for nothing.
#version 450
#include "peer_conventions.glsl"
#include "ssr_ray.glsl"

layout(std140, binding = 0) uniform PeerRecordBlock {
  vec2 size_px;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  float near_m;
  float thickness_m;
  float thickness_rel;
  float max_distance_m;
  float origin_bias;
  int lookup_budget;
  int peer_answer_form;
  int peer_hit_channel;
  int peer_lookups_channel;  // below 0: it counts none
};

layout(binding = 1) uniform sampler2D dist_view;
layout(binding = 2) uniform sampler2D normal_view;
layout(binding = 3) uniform sampler2D material;
layout(binding = 4) uniform sampler2D peer_answer;

layout(location = 0) out ivec2 hit_texel;
layout(location = 1) out vec4 hit_point;
layout(location = 2) out uvec4 ray_work;

// What becomes of this pixel's ray where nothing is hit.
int class_without_hit(ivec2 texel) {
  float own_dist_view = texelFetch(dist_view, texel, 0).x;
  if (isinf(own_dist_view)) {
    return RAY_BACKGROUND;
  }
  if (texelFetch(material, texel, 0).b == 0.0) {
    return RAY_MASKED;
  }
  vec4 normal_and_clearance = texelFetch(normal_view, texel, 0);
  vec3 normal = ordered_normalize(normal_and_clearance.xyz);
  TraceParameters parameters =
      TraceParameters(size_px, near_m, thickness_m, thickness_rel, max_distance_m, origin_bias, lookup_budget, 0, 0.0, 0,
                      1.0, 0.0, 0, 1.0, 0.0);
  Ray ray = ray_reflected(vec2(texel) + 0.5, own_dist_view, normal, PixelProjection(px_scale, px_offset, view_per_px),
                          parameters);
  bool into_surface = ordered_dot(ray.dir_view, normal) < 0.0 || normal_and_clearance.a < 0.0;
  return into_surface ? RAY_INTO_SURFACE : ray.end_class;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 answer = texelFetch(peer_answer, texel, 0);
  int missed = class_without_hit(texel);
  bool has_ray = missed != RAY_BACKGROUND && missed != RAY_MASKED && missed != RAY_INTO_SURFACE;
  int lookups = peer_lookups_channel < 0 || !has_ray ? 0 : int(clamp(answer[peer_lookups_channel], 0.0, 65535.0));
  RayHit hit = ray_without_hit(missed, lookups, lookups);
  vec2 p_px = peer_position_px(answer.xy, size_px, peer_answer_form);
  bool is_inside = peer_answer_form == PEER_ANSWER_MASK ||
                   (all(greaterThanEqual(p_px, vec2(0.0))) && all(lessThan(p_px, size_px)));
  if (has_ray && answer[peer_hit_channel] > 0.0 && is_inside) {
    bool has_position = peer_answer_form != PEER_ANSWER_MASK;
    hit.ray_class = RAY_HIT;
    hit.texel = has_position ? ivec2(floor(p_px)) : texel;
    hit.p_px = has_position ? p_px : vec2(texel) + 0.5;
    hit.t_m = 0.0;
  }
  hit_texel = hit.texel;
  hit_point = vec4(hit.p_px, hit.t_m, 0.0);
  ray_work = uvec4(hit.ray_class, hit.lookups, hit.steps, 0);
}
