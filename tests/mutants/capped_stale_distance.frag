// Mutant of trace_capped.frag: the bisection's distances are all the first middle's.
#version 450
#include "trace_entry.glsl"
#include "ssr_ray.glsl"
#include "ssr_step.glsl"

// Halves [s_front, s_behind] while its far end stays behind a surface; texel is the far end's.
float bisect_s(Ray ray, float s_front, float s_behind, int bisections, inout vec2 texel, TraceParameters parameters) {
  float inv_dist_middle = ray_inv_dist(ray, 0.5 * (s_front + s_behind));
  for (int i = 0; i < bisections; ++i) {
    float s_middle = 0.5 * (s_front + s_behind);
    vec2 texel_middle = texel_at(ray_position_px(ray, s_middle), parameters);
    float dist_middle = load_dist_view(texel_middle);
    bool is_behind = inv_dist_middle * dist_middle <= 1.0 && any(notEqual(texel_middle, ray.own_texel));
    s_front = is_behind ? s_front : s_middle;
    if (is_behind) {
      s_behind = s_middle;
      texel = texel_middle;
    }
  }
  return s_behind;
}

// Looks at s_step, 2 s_step, ... and last at s_end, s_offset before each of them.
RayHit march_strided(Ray ray, float s_end, float s_step, float s_offset, float samples, TraceParameters parameters) {
  float s_front = 0.0;
  float s_behind = 0.0;
  float inv_dist_front = ray.inv_dist_origin;
  vec2 texel = ray.own_texel;
  int lookups = 0;
  bool is_hit = false;
  bool is_over = false;
  for (int i = 1; i <= MAX_MARCH_STEPS; ++i) {
    is_over = float(i) > samples;
    if (is_over || lookups >= parameters.lookup_budget) {
      break;
    }
    s_behind = min(float(i) * s_step - s_offset, s_end);
    texel = texel_at(ray_position_px(ray, s_behind), parameters);
    float inv_dist_behind = ray_inv_dist(ray, s_behind);
    float dist_view = load_dist_view(texel);
    ++lookups;
    is_hit = inv_dist_behind * dist_view <= 1.0 &&
             max(inv_dist_front, inv_dist_behind) * column_far_m(dist_view, parameters) > 1.0 &&
             any(notEqual(texel, ray.own_texel));
    if (is_hit) {
      break;
    }
    s_front = s_behind;
    inv_dist_front = inv_dist_behind;
  }
  if (!is_hit) {
    return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, lookups);
  }
  int bisections = min(parameters.bisection_count, parameters.lookup_budget - lookups);
  s_behind = bisect_s(ray, s_front, s_behind, bisections, texel, parameters);
  int all_lookups = lookups + max(bisections, 0);
  vec2 p_px = position_inside_px(ray_position_px(ray, s_behind), parameters);
  return RayHit(ivec2(texel), p_px, ray_t_m(ray, s_behind), RAY_HIT, all_lookups, all_lookups);
}

// stride_px pixels from sample to sample, along the ray's longer axis.
RayHit march_dda_strided(Ray ray, TraceParameters parameters) {
  float s_end = ray_end_s(ray);
  float s_step = parameters.stride_px / max(max(abs(ray.px_per_s.x), abs(ray.px_per_s.y)), PARALLEL_PX);
  float s_offset = march_offset(ray, s_step, parameters);
  return march_strided(ray, s_end, s_step, s_offset, ceil((s_end + s_offset) / s_step), parameters);
}

RayHit march_capped(Ray ray, TraceParameters parameters) {
  float s_end = ray_end_s(ray);
  float length_px = s_end * max(abs(ray.px_per_s.x), abs(ray.px_per_s.y));
  float samples = clamp(ceil(length_px / parameters.stride_px), 1.0, float(parameters.step_count));
  float s_step = s_end / samples;
  float s_offset = march_offset(ray, s_step, parameters);
  return march_strided(ray, s_end, s_step, s_offset, samples, parameters);
}

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_capped(ray, trace_parameters());
  }
  trace_end(hit);
}
