// What the marches along the 3-D ray share: one look at the depth image, the test of a step, the refinement.
//
// Needs: float load_dist_view(vec2 texel)    metres, +inf for background
#ifndef SSR_SAMPLE_GLSL
#define SSR_SAMPLE_GLSL

#include "ssr_ray.glsl"

struct MarchSample {
  vec2 texel;
  vec2 p_px;
  float dist_ray;   // of the ray
  float dist_view;  // of the depth image there
};

MarchSample march_sample(Ray ray, float t_m, PixelProjection projection, TraceParameters parameters) {
  vec3 p_view = ray.origin_view + t_m * ray.dir_view;
  vec2 p_px = position_view_to_px(p_view, projection);
  vec2 texel = texel_at(p_px, parameters);
  return MarchSample(texel, p_px, -p_view.z, load_dist_view(texel));
}

// Whether the step that ends at `behind` meets its texel's column. The step's depth interval against the column: a step
// longer than the thickness does not jump over it. dist_front is the ray's dist_view at the step's beginning.
bool step_hits(Ray ray, MarchSample behind, float dist_front, TraceParameters parameters) {
  return behind.dist_ray >= behind.dist_view &&
         min(behind.dist_ray, dist_front) < column_far_m(behind.dist_view, parameters) &&
         any(notEqual(behind.texel, ray.own_texel));
}

// One-sided bisections of [t_front_m, t_behind_m], of which `behind` is the far end. The far end is behind a surface at
// every moment, so refinement never loses a hit (a symmetric thickness window would).
float bisect_t(Ray ray, float t_front_m, float t_behind_m, int bisections, inout MarchSample behind,
               PixelProjection projection, TraceParameters parameters) {
  for (int i = 0; i < bisections; ++i) {
    float t_middle_m = 0.5 * (t_front_m + t_behind_m);
    MarchSample middle = march_sample(ray, t_middle_m, projection, parameters);
    bool is_behind = middle.dist_ray >= middle.dist_view && any(notEqual(middle.texel, ray.own_texel));
    t_front_m = is_behind ? t_front_m : t_middle_m;
    t_behind_m = is_behind ? t_middle_m : t_behind_m;
    if (is_behind) {
      behind = middle;
    }
  }
  return t_behind_m;
}

#endif
