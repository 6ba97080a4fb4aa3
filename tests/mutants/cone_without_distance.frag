// Mutant of resolve_cone.frag: the mip by roughness alone.
//
// In:  hit_texel, hit_point, lit, lit_mips (linear, mip 0 is lit), material, dist_view.
// Out: reflection, rgb linear radiance, a = 1 where the ray hit; zero elsewhere.
// At contact the cone has no width and the mip is 0: the hit texel itself. Silhouettes stay sharp, for one ray is
// traced.
#version 450
#include "cone.glsl"

layout(std140, binding = 0) uniform ConeBlock {
  vec2 texel_uv;
  vec2 px_scale;
};

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D hit_point;
layout(binding = 3) uniform sampler2D lit;
layout(binding = 4) uniform sampler2D lit_mips;
layout(binding = 5) uniform sampler2D material;
layout(binding = 6) uniform sampler2D dist_view;

layout(location = 0) out vec4 reflection;

// Four trilinear samples in the place of one: a single one shows the mip's texels as diamonds. They close up to one
// where the mip nears 0.
vec3 smooth_mip(vec2 p_px, float mip) {
  float spread_px = 0.5 * (exp2(mip) - 1.0);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(i & 1, i >> 1) * 2.0 - 1.0;
    sum += textureLod(lit_mips, (p_px + spread_px * corner) * texel_uv, mip).rgb;
  }
  return 0.25 * sum;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 hit = texelFetch(hit_texel, texel, 0).xy;
  if (hit.x < 0) {
    reflection = vec4(0.0);
    return;
  }
  float roughness = texelFetch(material, texel, 0).g;
  float radius_m = cone_circle_per_m(cone_tangent(roughness));
  float mip = circle_mip(radius_m * abs(px_scale.y) / texelFetch(dist_view, hit, 0).x);
  reflection = vec4(mip > 0.0 ? smooth_mip(vec2(hit) + 0.5, mip) : texelFetch(lit, hit, 0).rgb, 1.0);
}
