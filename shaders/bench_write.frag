// A roofline: a ray record of no ray, written and nothing else; what every tracer pays for its outputs.
//
// Out: hit_texel, hit_point, ray_work as a tracer writes them.
#version 450
#include "ssr_contract.glsl"

layout(location = 0) out ivec2 hit_texel;
layout(location = 1) out vec4 hit_point;
layout(location = 2) out uvec4 ray_work;

void main() {
  RayHit hit = ray_without_hit(RAY_MASKED, 0, 0);
  hit_texel = hit.texel;
  hit_point = vec4(hit.p_px, hit.t_m, 0.0);
  ray_work = uvec4(hit.ray_class, hit.lookups, hit.steps, 0);
}
