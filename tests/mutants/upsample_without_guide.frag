// Mutant of upsample.frag: the mean of both rays, whatever the surfaces.
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
  vec2 weights = vec2(1.0);
  vec2 hits = vec2(a.a > 0.0 ? weights.x : 0.0, b.a > 0.0 ? weights.y : 0.0);
  float hit_count = hits.x + hits.y;
  vec3 radiance = (hit_count > 1.0 ? 0.5 : 1.0) * (hits.x * a.rgb + hits.y * b.rgb);
  reflection = vec4(radiance, weights.x + weights.y > 1.0 ? 0.5 * hit_count : hit_count);
}
