// Lights the G-buffer by the metallic-roughness model: GGX from directional and punctual lights, the environment's
// irradiance and its specular reflection, emission; the environment where there is no surface.
//
// In: albedo, normal_view, material, emission, dist_view; shadow (1: the first directional light arrives), ao (1: all
// of the irradiance does); environment, irradiance, split_sum.
// Out: lit, linear radiance; lit_base, the same without the environment's specular reflection, for a composite to put
// something better in its place. Both are finite: at most the largest half.
// Formulas and papers: brdf_ggx.glsl, environment.glsl.
#version 450
#include "punctual_lights.glsl"
#include "surface_ggx.glsl"

const int MAX_LIGHTS = 8;
const float LARGEST_HALF = 65504.0;

// Of the scene: loops of a known length are written out, and a light's members are read at once.
layout(constant_id = 0) const int directional_count = 1;
layout(constant_id = 1) const int point_count = 0;

layout(std140, binding = 0) uniform LightBlock {
  vec2 px_offset;
  vec2 view_per_px;
  vec2 texel_uv;
  mat4 view_from_world;
  float environment_side;
  float environment_mip_count;
  float irradiance_side;
  float split_sum_side;
  vec4 directional_dir_view[MAX_LIGHTS];  // the way the light travels
  vec4 directional_radiance[MAX_LIGHTS];
  vec4 point_p_view[MAX_LIGHTS];     // a: range in metres, 0 unlimited
  vec4 point_dir_view[MAX_LIGHTS];   // a: cosine of the outer cone, -1 for a point light
  vec4 point_intensity[MAX_LIGHTS];  // a: cosine of the inner cone
};

layout(binding = 1) uniform sampler2D albedo;
layout(binding = 2) uniform sampler2D normal_view;
layout(binding = 3) uniform sampler2D material;
layout(binding = 4) uniform sampler2D emission;
layout(binding = 5) uniform sampler2D dist_view;
layout(binding = 6) uniform sampler2D shadow;
layout(binding = 7) uniform sampler2D ao;
layout(binding = 8) uniform sampler2D environment;
layout(binding = 9) uniform sampler2D irradiance;
layout(binding = 10) uniform sampler2D split_sum;

layout(location = 0) out vec4 lit;
layout(location = 1) out vec4 lit_base;

vec3 load_environment(vec2 uv, float mip) { return textureLod(environment, uv, mip).rgb; }

vec3 reflected_light(GgxSurface surface, vec3 to_light, vec3 arriving, vec2 split) {
  float cos_light = ordered_dot(surface.normal, to_light);
  return cos_light > 0.0 ? ggx_brdf(surface, to_light, cos_light, split) * arriving * cos_light : vec3(0.0);
}

// The way to a light, and what arrives from it.
struct Arriving {
  vec3 to_light;
  vec3 irradiance;
};

Arriving from_directional(int i, float first_visible) {
  float visible = i == 0 ? first_visible : 1.0;
  return Arriving(-directional_dir_view[i].xyz, visible * directional_radiance[i].rgb);
}

// A light at the very point that it lights comes from nowhere: it adds nothing there.
Arriving from_point(int i, vec3 p_view) {
  vec3 offset_m = point_p_view[i].xyz - p_view;
  float distance_m = sqrt(ordered_dot(offset_m, offset_m));
  vec3 to_light = offset_m / max(distance_m, 1e-6);
  float falloff = punctual_falloff(distance_m, point_p_view[i].a, -ordered_dot(to_light, point_dir_view[i].xyz),
                                   point_intensity[i].a, point_dir_view[i].a);
  return Arriving(to_light, point_intensity[i].rgb * falloff);
}

vec3 all_lights(GgxSurface surface, vec2 split, vec3 p_view, float first_visible) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < directional_count; ++i) {
    Arriving light = from_directional(i, first_visible);
    radiance += reflected_light(surface, light.to_light, light.irradiance, split);
  }
  for (int i = 0; i < point_count; ++i) {
    Arriving light = from_point(i, p_view);
    radiance += reflected_light(surface, light.to_light, light.irradiance, split);
  }
  return radiance;
}

// Lights, emission and the irradiance: all but the environment's specular reflection.
vec3 base_radiance(GgxSurface surface, vec2 split, float dist) {
  vec2 uv = gl_FragCoord.xy * texel_uv;
  EnvironmentLayout maps = EnvironmentLayout(environment_side, environment_mip_count, irradiance_side, split_sum_side);
  vec3 radiance = textureLod(emission, uv, 0.0).rgb;
  vec3 p_view = vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0) * dist;
  radiance += all_lights(surface, split, p_view, textureLod(shadow, uv, 0.0).r);
  vec3 around = textureLod(irradiance, irradiance_uv(surface.normal * mat3(view_from_world), maps), 0.0).rgb;
  return radiance + textureLod(ao, uv, 0.0).r * surface.diffuse * (1.0 - specular_albedo(surface.f0, split)) * around;
}

void main() {
  // Nearest samples in the place of texelFetch: the same texels in less time on llvmpipe.
  vec2 uv = gl_FragCoord.xy * texel_uv;
  EnvironmentLayout maps = EnvironmentLayout(environment_side, environment_mip_count, irradiance_side, split_sum_side);
  float dist = textureLod(dist_view, uv, 0.0).x;
  vec3 to_eye = -ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec4 metal_rough = textureLod(material, uv, 0.0);
  vec3 normal = unit_normal(textureLod(normal_view, uv, 0.0).xyz, to_eye);
  GgxSurface surface = ggx_surface(textureLod(albedo, uv, 0.0).rgb, metal_rough.xy, normal, to_eye);
  // One lookup for what is seen and for what is mirrored: both sides of a branch cost, on many devices.
  bool is_background = isinf(dist);
  vec3 direction = is_background ? -to_eye : mirrored(surface);
  float roughness = is_background ? 0.0 : metal_rough.y;
  vec3 arriving = environment_radiance(direction * mat3(view_from_world), roughness, maps);
  vec2 split = textureLod(split_sum, split_sum_uv(surface.cos_view, metal_rough.y, maps), 0.0).rg;
  vec3 base = base_radiance(surface, split, dist);
  vec3 all = base + specular_albedo(surface.f0, split) * arriving;
  lit_base = vec4(is_background ? arriving : min(base, LARGEST_HALF), 1.0);
  lit = vec4(is_background ? arriving : min(all, LARGEST_HALF), 1.0);
}
