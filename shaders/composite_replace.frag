// Puts each reflection in the place of the environment's: the sum over light stays a sum in which the specular part
// appears once.
//
// In: lit, lit_base, reflection (a: confidence), albedo, normal_view, material; split_sum.
// Out: composite, linear radiance; lit itself, bit by bit, where no ray was traced or found anything.
// With environment E, reflection R, confidence c and specular albedo w as in light_ggx.frag: lit_base + w mix(E, R, c),
// where w E is what lit has over lit_base.
// Deliot, "OpenGL engine and PBR deferred pipeline with SSR/SSAO", feeds each hit to the specular image-based light so.
#version 450
#include "surface_ggx.glsl"

const float LARGEST_HALF = 65504.0;

layout(std140, binding = 0) uniform CompositeBlock {
  vec2 px_offset;
  vec2 view_per_px;
  vec2 texel_uv;
  float split_sum_side;
};

layout(binding = 1) uniform sampler2D lit;
layout(binding = 2) uniform sampler2D lit_base;
layout(binding = 3) uniform sampler2D reflection;
layout(binding = 4) uniform sampler2D albedo;
layout(binding = 5) uniform sampler2D normal_view;
layout(binding = 6) uniform sampler2D material;
layout(binding = 7) uniform sampler2D split_sum;

layout(location = 0) out vec4 composite;

void main() {
  // Nearest samples in the place of texelFetch: the same texels in less time on llvmpipe.
  vec2 uv = gl_FragCoord.xy * texel_uv;
  vec4 found = textureLod(reflection, uv, 0.0);
  vec4 metal_rough = textureLod(material, uv, 0.0);
  vec3 around = textureLod(lit, uv, 0.0).rgb;
  if (found.a <= 0.0 || metal_rough.b <= 0.0) {
    composite = vec4(around, 1.0);
    return;
  }
  EnvironmentLayout maps = EnvironmentLayout(0.0, 0.0, 0.0, split_sum_side);
  vec3 to_eye = -ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec3 normal = unit_normal(textureLod(normal_view, uv, 0.0).xyz, to_eye);
  GgxSurface surface = ggx_surface(textureLod(albedo, uv, 0.0).rgb, metal_rough.xy, normal, to_eye);
  vec2 split = textureLod(split_sum, split_sum_uv(surface.cos_view, metal_rough.y, maps), 0.0).rg;
  // In one order: drivers write mix() out in several ways, and a half's last bit would tell (docs/precision.md).
  precise vec3 replaced = textureLod(lit_base, uv, 0.0).rgb + specular_albedo(surface.f0, split) * found.rgb;
  precise vec3 mixed = around + min(found.a, 1.0) * (replaced - around);
  composite = vec4(min(mixed, LARGEST_HALF), 1.0);
}
