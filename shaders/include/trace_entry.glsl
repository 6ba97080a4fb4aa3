// What every trace_*.frag shares: bindings, the ray's surface, the record. An entry file includes this, defines how the
// depth is read, includes its march and calls trace_begin and trace_end.
//
// In:  dist_view, normal_view (a: cosine between the reflected direction and the geometric normal); the depth test, which
//      leaves the texels that rays are traced from (without_ray.frag).
// Out: hit_texel (x, y; -1 none), hit_point (p_px, t_m; -1 none), ray_work (class, lookups, steps).
#ifndef TRACE_ENTRY_GLSL
#define TRACE_ENTRY_GLSL

#include "ssr_ray.glsl"

layout(std140, binding = 0) uniform TraceBlock {
  vec2 size_px;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  vec2 texel_uv;        // 1 / size_px
  vec2 atlas_texel_uv;  // 1 / size of the pyramid atlas
  float atlas_rows;     // rows that its levels above the base start after
  float near_m;
  float thickness_m;
  float thickness_rel;
  float max_distance_m;
  float origin_bias;
  float step_m;
  float stride_px;
  float jitter;
  int lookup_budget;
  int step_count;
  int bisection_count;
  int max_mip;
  int ray_stride_texels;  // this fragment's ray starts from the texel that is its own position times this
  float step_growth;
  float first_step_share;
  mat4 clip_from_view;
  mat4 view_from_world;
  mat4 world_from_view;
};

layout(binding = 1) uniform sampler2D dist_view;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out ivec2 hit_texel;
layout(location = 1) out vec4 hit_point;
layout(location = 2) out uvec4 ray_work;

// What a branch or a loop's end hangs on is the pixel's too, though it is the same for each: of a uniform alone lavapipe
// makes a constant (Mesa's lvp_inline_uniforms), and with it a new shader at every draw, 1.4 ms by one thread, whose code
// it keeps.
TraceParameters trace_parameters() {
  bool is_pixel = gl_FragCoord.x > 0.0;
  int pixel_lookup_budget = is_pixel ? lookup_budget : 0;
  float pixel_stride_px = is_pixel ? stride_px : 1.0;
  return TraceParameters(size_px, near_m, thickness_m, thickness_rel, max_distance_m, origin_bias, pixel_lookup_budget,
                         step_count, step_m, bisection_count, pixel_stride_px, jitter, max_mip, step_growth,
                         first_step_share);
}

PixelProjection trace_projection() { return PixelProjection(px_scale, px_offset, view_per_px); }

// What a loop reads is copied out of the block once: Mesa's software drivers read a member lane by lane, and anew in every
// iteration. It is a quarter of the walk's time.
vec2 dist_view_texel_uv = texel_uv;

// A nearest sample instead of texelFetch: the same texel, and 1.7 times as fast on llvmpipe.
float load_dist_view(vec2 texel) { return textureLod(dist_view, (texel + 0.5) * dist_view_texel_uv, 0.0).x; }

// Whether this pixel's ray is to be marched; if not, `hit` is its record.
bool trace_begin(out Ray ray, out RayHit hit) {
  ivec2 texel = ivec2(gl_FragCoord.xy) * ray_stride_texels;
  vec2 own_uv = (vec2(texel) + 0.5) * dist_view_texel_uv;
  float own_dist_view = textureLod(dist_view, own_uv, 0.0).x;
  vec4 normal_and_clearance = textureLod(normal_view, own_uv, 0.0);
  vec3 normal = ordered_normalize(normal_and_clearance.xyz);
  ray = ray_reflected(vec2(texel) + 0.5, own_dist_view, normal, trace_projection(), trace_parameters());
  bool into_surface = ordered_dot(ray.dir_view, normal) < 0.0 || normal_and_clearance.a < 0.0;
  bool is_background = isinf(own_dist_view);
  int end_class = into_surface ? RAY_INTO_SURFACE : ray.end_class;
  hit = ray_without_hit(is_background ? RAY_BACKGROUND : end_class, 0, 0);
  return !is_background && !into_surface && ray.s_end > 0.0;
}

void trace_end(RayHit hit) {
  hit_texel = hit.texel;
  hit_point = vec4(hit.p_px, hit.t_m, 0.0);
  ray_work = uvec4(hit.ray_class, hit.lookups, hit.steps, 0);
}

#endif
