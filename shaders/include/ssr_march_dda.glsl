// The screen-space DDA: one sample a texel along the ray's longer axis on the image, perspective-correct (McGuire and
// Mara, "Efficient GPU Screen-Space Ray Tracing", JCGT 3(4) 2014, sections 3 and 4). Strides over one texel are
// ssr_march_strided.glsl.
//
// In: a clipped ray. Out: the first sampled texel whose column the ray overlaps. On a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// A sample is the texel at the ray's position in the middle of a column (a row, for steep rays); the depth interval tested
// is the ray's inside that texel and inside the segment. So what it finds is true of that texel, and all it can miss is a
// texel that the ray crosses beside the column's middle: the 8-connected walk leaks through diagonal lines.
#ifndef SSR_MARCH_DDA_GLSL
#define SSR_MARCH_DDA_GLSL

#include "ssr_ray.glsl"

RayHit march_dda(Ray ray, TraceParameters parameters) {
  bool x_is_primary = abs(ray.px_per_s.x) >= abs(ray.px_per_s.y);
  vec2 primary = x_is_primary ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  vec2 far_edge = ray_far_edge(ray);
  vec2 direction = 2.0 * far_edge - 1.0;
  // The far edge of the last sampled column along the primary axis. Sampling starts behind the origin's column, in which
  // an unbiased ray cannot leave its own texel sideways, or with it where the bias moved the origin.
  vec2 column_edge = floor(ray.origin_px) + far_edge;
  float s_column_in = ordered_dot(ray_s_at_edges(ray, column_edge), primary);
  bool is_biased = parameters.origin_bias > 0.0;
  column_edge -= is_biased ? direction : vec2(0.0);
  s_column_in = is_biased ? 0.0 : s_column_in;
  column_edge -= direction * (parameters.jitter * dither_noise(ray.own_texel + 0.5));
  vec2 half_texel = (1.0 - primary) * 0.5;
  float s_half_column = 0.5 * abs(ordered_dot(ray.s_per_px, primary));
  float s_in = 0.0;
  float s_out = 0.0;
  float s_sample = 0.0;
  vec2 texel = vec2(0.0);
  float dist_view = 0.0;
  int lookups = 0;
  bool is_hit = false;
  bool is_over = s_column_in >= ray.s_end;
  for (int i = 0; i < parameters.lookup_budget; ++i) {
    if (is_over) {
      break;
    }
    column_edge += direction;
    float s_column_out = ordered_dot(ray_s_at_edges(ray, column_edge), primary);
    s_sample = clamp(s_column_out - s_half_column, 0.0, ray.s_end);
    texel = texel_at(ray_position_px(ray, s_sample), parameters);
    // The texel's edges across the secondary axis.
    vec2 middle = texel + 0.5;
    float s_texel_a = ordered_dot(ray_s_at_edges(ray, middle - direction * half_texel), 1.0 - primary);
    float s_texel_b = ordered_dot(ray_s_at_edges(ray, middle + direction * half_texel), 1.0 - primary);
    s_in = max(s_column_in, s_texel_a);
    s_out = min(min(s_column_out, s_texel_b), ray.s_end);
    dist_view = load_dist_view(texel);
    ++lookups;
    is_hit = s_in <= s_out && column_overlaps(ray_inv_dist(ray, s_in), ray_inv_dist(ray, s_out), dist_view, parameters) &&
             any(notEqual(texel, ray.own_texel));
    is_over = is_hit || s_column_out >= ray.s_end;
    s_column_in = s_column_out;
  }
  if (!is_hit) {
    return ray_without_hit(is_over ? ray.end_class : RAY_BUDGET, lookups, lookups);
  }
  return ray_hit_in_texel(ray, texel, dist_view, s_in, s_out, lookups, lookups, parameters);
}

#endif
