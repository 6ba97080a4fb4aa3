// Brings a half-resolution reflection to full size: each texel lies on a ray or in the middle between two, and takes from
// both what started from its own surface (joint_bilateral.glsl).
//
// In:  reflection_half (resolve_half.frag), dist_view.
// Out: reflection, rgb linear radiance, a the share of the rays that hit. Means nothing on texels that reflect nothing: the
//      material is not read.
// The ray of a 2 x 2 block starts at its upper left texel, which lies in the image at every size. A straight edge cannot
// part a texel from both rays of which it is the middle, so two are enough: the right and the lower neighbour's for texels
// in odd columns and rows, the one across the block for those in both; beyond the last column and row the block's own.
// Every read counts here: the pass is held to a tenth of the trace (tests/expect/half_res_cpu_time.toml).
#version 450
#include "joint_bilateral.glsl"

layout(std140, binding = 0) uniform UpsampleBlock {
  vec2 view_per_px;
  vec2 texel_uv;
  vec2 rays_uv;  // 1 / size of the half-resolution images
};

layout(binding = 1) uniform sampler2D reflection_half;
layout(binding = 2) uniform sampler2D dist_view;

layout(location = 0) out vec4 reflection;

void main() {
  float dist = textureLod(dist_view, gl_FragCoord.xy * texel_uv, 0.0).x;
  // Nearest samples: x / 2 rounded down is the block, (x + 1) / 2 the next one from odd texels on.
  vec2 uv_per_px = 0.5 * rays_uv;
  vec4 a = textureLod(reflection_half, gl_FragCoord.xy * uv_per_px, 0.0);
  vec4 b = textureLod(reflection_half, (gl_FragCoord.xy + 1.0) * uv_per_px, 0.0);
  vec2 weights = same_surface_weights(dist, abs(a.a), abs(b.a), view_per_px.x);
  vec2 hits = vec2(a.a > 0.0 ? weights.x : 0.0, b.a > 0.0 ? weights.y : 0.0);
  float hit_count = hits.x + hits.y;
  vec3 radiance = (hit_count > 1.0 ? 0.5 : 1.0) * (hits.x * a.rgb + hits.y * b.rgb);
  reflection = vec4(radiance, weights.x + weights.y > 1.0 ? 0.5 * hit_count : hit_count);
}
