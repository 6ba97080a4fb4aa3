// Draws the scene's triangles into one cascade of the shadow map: orthographic, along the light.
#version 450

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

layout(location = 0) out vec2 uv;
layout(location = 1) flat out float facing;  // positive where the light meets the triangle's front
layout(location = 2) flat out float material_index;

void main() {
  vec3 p_light = (light_from_world * vec4(in_p_world, 1.0)).xyz;
  uv = in_uv;
  facing = -(mat3(light_from_world) * in_face_normal_world).z;
  material_index = in_material_index;
  vec4 cascade = shadow_cascades[shadow_cascade];
  vec2 map_px = (p_light.xy - cascade.xy) * cascade.w;
  // Light space's y grows as the map's rows do, and row 0 is the rasteriser's y = -1 on every API: no flip.
  gl_Position = vec4(2.0 * map_px / shadow_side_texels - 1.0, (p_light.z - shadow_near_m) / shadow_range_m, 1.0);
}
