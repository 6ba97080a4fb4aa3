// Draws the scene's triangles into one cascade of the shadow map: orthographic, along the light.
//
// The rule of what casts is the G-buffer's own (gbuffer.frag), with the light in the camera's place: a single-sided
// triangle is there from its front only, a double-sided one from both sides. So a room's inward-facing wall lets light in
// from outside, as it lets the camera look in. All three corners of a triangle that is not there go outside the map.
#version 450
#include "material_flags.glsl"
#include "ssr_ordered.glsl"

layout(std140, binding = 0) uniform ShadowMapBlock {
  mat4 light_from_world;
  vec4 shadow_cascades[4];  // xy of the first texel's corner in light space, metres a texel, 1 / that
  int shadow_cascade;       // the one that is drawn
  float shadow_side_texels;
  float shadow_near_m;
  float shadow_range_m;
};

layout(location = 0) in vec3 in_p_world;
layout(location = 3) in vec2 in_uv;
layout(location = 4) in vec3 in_face_normal_world;
layout(location = 5) in float in_material_index;

layout(binding = 1) uniform sampler2D material_table;

layout(location = 0) out vec2 uv;
layout(location = 1) flat out vec3 alpha;  // the material's, its cutoff, and 1 where a texture counts too

void main() {
  vec3 p_light = ordered_transform(light_from_world, vec4(in_p_world, 1.0)).xyz;
  uv = in_uv;
  vec4 cascade = shadow_cascades[shadow_cascade];
  vec2 map_px = (p_light.xy - cascade.xy) * cascade.w;
  // Light space's y grows as the map's rows do, and row 0 is the rasteriser's y = -1 on every API: no flip.
  gl_Position = vec4(2.0 * map_px / shadow_side_texels - 1.0, (p_light.z - shadow_near_m) / shadow_range_m, 1.0);
  int row = int(in_material_index);
  vec4 surface = texelFetch(material_table, ivec2(1, row), 0);
  alpha = vec3(texelFetch(material_table, ivec2(0, row), 0).a, surface.a,
               material_has(surface, MATERIAL_BASE_COLOUR_TEXTURE) ? 1.0 : 0.0);
  bool is_double_sided = material_has(surface, MATERIAL_DOUBLE_SIDED);
  bool faces_light = ordered_transform(light_from_world, vec4(in_face_normal_world, 0.0)).z < 0.0;
  if (!faces_light && !is_double_sided) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
}
