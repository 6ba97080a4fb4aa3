// Writes the G-buffer: what later passes know of each pixel's nearest surface.
//
// Out: albedo     rgb base colour, linear
//      normal_view xyz unit shading normal; a cosine between the reflected view direction and the geometric normal,
//                 negative where a normal map bends the reflection below the surface
//      material   r metallic, g roughness, b 1 where rays are traced, a 1 (background: 0, by the clear)
//      emission   rgb, linear
//      dist_view  metres (background: +inf, by the clear)
//      motion     pixels: p_px now minus p_px of the same surface point in the previous frame; +inf where the point was
//                 not before the near plane then (background: 0, by the clear)
//      dist_range level 0 of the depth pyramid, least and greatest dist_view (background: +inf and 0, by the clear):
//                 rasterised here it is copied, not drawn anew from dist_view (pyramid_base.frag)
#version 450
#include "material_flags.glsl"
#include "ssr_motion.glsl"
#include "ssr_ordered.glsl"

// Of the scene, 0 or 1: whether any of its materials has one. Software rasterisers sample in the branches that no pixel
// takes, too.
layout(constant_id = 0) const int has_base_colour_texture = 1;
layout(constant_id = 1) const int has_metallic_roughness_texture = 1;
layout(constant_id = 2) const int has_normal_texture = 1;
layout(constant_id = 3) const int has_emissive_texture = 1;

layout(binding = 2) uniform sampler2D base_colour_texture;
layout(binding = 3) uniform sampler2D metallic_roughness_texture;
layout(binding = 4) uniform sampler2D normal_texture;
layout(binding = 5) uniform sampler2D emissive_texture;

layout(location = 0) in vec3 p_view;
layout(location = 1) in vec3 normal_view;
layout(location = 2) in vec4 tangent_view;
layout(location = 3) in vec2 uv;
layout(location = 4) flat in vec3 face_normal_view;
layout(location = 5) flat in vec4 base_colour;
layout(location = 6) in vec3 p_previous_view;
layout(location = 7) flat in vec3 px_scale_and_near;
layout(location = 8) flat in vec4 surface;
layout(location = 9) flat in vec4 emissive_and_scale;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal_and_clearance;
layout(location = 2) out vec4 material;
layout(location = 3) out vec4 emission;
layout(location = 4) out float dist_view;
layout(location = 5) out vec2 motion;
layout(location = 6) out vec2 dist_range;

// Shading normal in view space, turned with the face (side is -1 on the back of a double-sided triangle).
vec3 shading_normal(float side, float normal_scale, bool is_mapped) {
  vec3 normal = side * ordered_normalize(normal_view);
  if (!is_mapped) {
    return normal;
  }
  vec3 tangent = ordered_normalize(tangent_view.xyz - ordered_dot(normal, tangent_view.xyz) * normal);
  vec3 bitangent = (side * tangent_view.w) * cross(normal, tangent);
  vec3 texel = 2.0 * texture(normal_texture, uv).xyz - 1.0;
  texel.xy *= normal_scale;
  return ordered_normalize((texel.x * tangent + texel.y * bitangent) + texel.z * normal);
}

void main() {
  float side = ordered_dot(face_normal_view, p_view) > 0.0 ? -1.0 : 1.0;
  bool has_colour = has_base_colour_texture != 0 && material_has(surface, MATERIAL_BASE_COLOUR_TEXTURE);
  vec4 sampled_colour = has_colour ? base_colour * texture(base_colour_texture, uv) : base_colour;
  if ((side < 0.0 && !material_has(surface, MATERIAL_DOUBLE_SIDED)) || sampled_colour.a < surface.a) {
    discard;
  }
  bool has_normal = has_normal_texture != 0 && material_has(surface, MATERIAL_NORMAL_TEXTURE);
  vec3 normal = shading_normal(side, emissive_and_scale.a, has_normal);
  vec3 reflected = ordered_reflect(ordered_normalize(p_view), normal);
  bool has_metal =
      has_metallic_roughness_texture != 0 && material_has(surface, MATERIAL_METALLIC_ROUGHNESS_TEXTURE);
  vec4 roughness_metal = has_metal ? texture(metallic_roughness_texture, uv) : vec4(1.0);
  albedo = vec4(sampled_colour.rgb, 1.0);
  normal_and_clearance = vec4(normal, ordered_dot(reflected, side * face_normal_view));
  float mirror = material_has(surface, MATERIAL_MIRROR) ? 1.0 : 0.0;
  material = vec4(surface.x * roughness_metal.b, surface.y * roughness_metal.g, mirror, 1.0);
  bool has_emissive = has_emissive_texture != 0 && material_has(surface, MATERIAL_EMISSIVE_TEXTURE);
  emission = vec4(emissive_and_scale.rgb * (has_emissive ? texture(emissive_texture, uv).rgb : vec3(1.0)), 1.0);
  dist_view = -p_view.z;
  dist_range = vec2(dist_view);
  motion = motion_px(p_view, p_previous_view, px_scale_and_near.xy, px_scale_and_near.z);
}
