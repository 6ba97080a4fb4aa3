// Fetches what each ray of a half-resolution trace hit, and packs the distance of the surface that it started from beside
// it: one texel of one image is all that the upsampling reads of a ray.
//
// In:  hit_texel, ray_work (half size), lit, dist_view.
// Out: reflection_half, rgb linear radiance, zero on a miss; a the dist_view of the ray's origin, negative on a miss, and
//      -NO_RAY_M where no ray was to be traced (MASKED, BACKGROUND).
#version 450
#include "joint_bilateral.glsl"
#include "ssr_contract.glsl"

layout(std140, binding = 0) uniform ResolveHalfBlock {
  int ray_stride_texels;
};

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform usampler2D ray_work;
layout(binding = 3) uniform sampler2D lit;
layout(binding = 4) uniform sampler2D dist_view;

layout(location = 0) out vec4 reflection_half;

void main() {
  ivec2 ray = ivec2(gl_FragCoord.xy);
  int ray_class = int(texelFetch(ray_work, ray, 0).x);
  if (ray_class == RAY_MASKED || ray_class == RAY_BACKGROUND) {
    reflection_half = vec4(vec3(0.0), -NO_RAY_M);
    return;
  }
  float dist = texelFetch(dist_view, ray * ray_stride_texels, 0).x;
  ivec2 hit = texelFetch(hit_texel, ray, 0).xy;
  reflection_half = hit.x >= 0 ? vec4(texelFetch(lit, hit, 0).rgb, dist) : vec4(vec3(0.0), -dist);
}
