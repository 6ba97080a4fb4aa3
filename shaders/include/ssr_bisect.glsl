// One-sided bisection on the image: halves, in pixels, the piece of the ray in which it has passed behind a surface.
//
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
// The far end is behind a surface at every moment, so no hit is lost; after n halvings the surface is within 2^-n of
// the piece's length on the image.
#ifndef SSR_BISECT_GLSL
#define SSR_BISECT_GLSL

#include "ssr_ray.glsl"

// Halves [s_front, s_behind] while its far end stays behind a surface; texel is the far end's.
float bisect_s(Ray ray, float s_front, float s_behind, int bisections, inout vec2 texel, TraceParameters parameters) {
  for (int i = 0; i < bisections; ++i) {
    float s_middle = 0.5 * (s_front + s_behind);
    vec2 texel_middle = texel_at(ray_position_px(ray, s_middle), parameters);
    float dist_middle = load_dist_view(texel_middle);
    bool is_behind = ray_inv_dist(ray, s_middle) * dist_middle <= 1.0 && any(notEqual(texel_middle, ray.own_texel));
    s_front = is_behind ? s_front : s_middle;
    if (is_behind) {
      s_behind = s_middle;
      texel = texel_middle;
    }
  }
  return s_behind;
}

#endif
