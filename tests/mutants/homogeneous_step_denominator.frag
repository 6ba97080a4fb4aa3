// Mutant of trace_homogeneous.frag: the denominator of one pixel for a step of N.
#version 450
#include "trace_entry.glsl"
#include "ssr_ray.glsl"
#include "ssr_step.glsl"

struct ClipRay {
  vec4 origin_clip;  // p
  vec4 dir_clip;     // d: one metre of the ray
  float move_px;     // M
};

ClipRay clip_ray(Ray ray, mat4 clip_from_view, vec2 size_px) {
  vec4 origin_clip = ordered_transform(clip_from_view, vec4(ray.origin_view, 1.0));
  vec4 dir_clip = ordered_transform(clip_from_view, vec4(ray.dir_view, 0.0));
  vec2 dir_ndc = vec2(dir_clip) - dir_clip.w * (vec2(origin_clip) / origin_clip.w);
  vec2 move_px = (0.5 * size_px) * abs(dir_ndc);
  return ClipRay(origin_clip, dir_clip, max(move_px.x, move_px.y));
}

// Where the ray is n_px pixels from its origin, in metres; t_end_m from the vanishing point on.
float homogeneous_t_m(ClipRay ray, float n_px, float t_end_m) {
  float denominator = ray.move_px - ray.dir_clip.w;
  return denominator > 0.0 ? min(n_px * ray.origin_clip.w / denominator, t_end_m) : t_end_m;
}

// The middle of a piece of the ray on the image, where x / w is the mean of the ends' x / w.
float homogeneous_middle_m(ClipRay ray, float t_a_m, float t_b_m) {
  float w_a = ray.origin_clip.w + t_a_m * ray.dir_clip.w;
  float w_b = ray.origin_clip.w + t_b_m * ray.dir_clip.w;
  return (t_a_m * w_b + t_b_m * w_a) / (w_a + w_b);
}

RayHit march_homogeneous(Ray ray, mat4 clip_from_view, TraceParameters parameters) {
  ClipRay clip = clip_ray(ray, clip_from_view, parameters.size_px);
  float t_end_m = ray_end_m(ray);
  float t_front_m = 0.0;
  float t_behind_m = 0.0;
  float dist_front = clip.origin_clip.w;
  vec4 q = clip.origin_clip;
  vec2 texel = ray.own_texel;
  int lookups = 0;
  bool is_hit = false;
  bool is_over = false;
  for (int i = 1; i <= MAX_MARCH_STEPS; ++i) {
    is_over = t_front_m >= t_end_m;
    if (is_over || lookups >= parameters.lookup_budget) {
      break;
    }
    ClipRay here = ClipRay(q, clip.dir_clip, clip.move_px * clip.origin_clip.w / q.w);
    t_behind_m = min(t_front_m + homogeneous_t_m(here, parameters.stride_px, t_end_m), t_end_m);
    q = clip.origin_clip + t_behind_m * clip.dir_clip;
    texel = texel_at(position_clip_to_px(q, parameters.size_px), parameters);
    float dist_view = load_dist_view(texel);
    ++lookups;
    is_hit = q.w >= dist_view && min(q.w, dist_front) < column_far_m(dist_view, parameters) &&
             any(notEqual(texel, ray.own_texel));
    if (is_hit) {
      break;
    }
    t_front_m = t_behind_m;
    dist_front = q.w;
  }
  if (!is_hit) {
    return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, lookups);
  }
  int bisections = min(parameters.bisection_count, parameters.lookup_budget - lookups);
  for (int i = 0; i < bisections; ++i) {
    float t_middle_m = homogeneous_middle_m(clip, t_front_m, t_behind_m);
    vec4 middle = clip.origin_clip + t_middle_m * clip.dir_clip;
    vec2 texel_middle = texel_at(position_clip_to_px(middle, parameters.size_px), parameters);
    bool is_behind = middle.w >= load_dist_view(texel_middle) && any(notEqual(texel_middle, ray.own_texel));
    t_front_m = is_behind ? t_front_m : t_middle_m;
    if (is_behind) {
      t_behind_m = t_middle_m;
      q = middle;
      texel = texel_middle;
    }
  }
  int all_lookups = lookups + max(bisections, 0);
  vec2 p_px = position_inside_px(position_clip_to_px(q, parameters.size_px), parameters);
  return RayHit(ivec2(texel), p_px, t_behind_m, RAY_HIT, all_lookups, all_lookups);
}

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_homogeneous(ray, clip_from_view, trace_parameters());
  }
  trace_end(hit);
}
