// The screen-space march with a cap: one sample every stride_px pixels along the ray's piece of the image, or step_count
// samples spread over it where that would be more; then bisection_count one-sided bisections of the last stride.
//
// In: a clipped ray. Out: the texel at the far end of the last bracket; on a miss texel, p_px and t_m are -1.
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// The number of samples is fixed before the march begins, and with it the cost of the worst pixel. Between the samples,
// and in the refinement too, the ray's dist_view follows its position: both come from one s.
// What it gets wrong: where the cap binds, the stride is the ray's length over the cap, so a longer ray, or a finer
// image, is sampled more coarsely on the way to the same hit.
#ifndef SSR_MARCH_CAPPED_GLSL
#define SSR_MARCH_CAPPED_GLSL

#include "ssr_march_strided.glsl"

RayHit march_capped(Ray ray, TraceParameters parameters) {
  float s_end = ray_end_s(ray);
  float length_px = s_end * max(abs(ray.px_per_s.x), abs(ray.px_per_s.y));
  float samples = clamp(ceil(length_px / parameters.stride_px), 1.0, float(parameters.step_count));
  float s_step = s_end / samples;
  float s_offset = march_offset(ray, s_step, parameters);
  return march_strided(ray, s_end, s_step, s_offset, samples, parameters);
}

#endif
