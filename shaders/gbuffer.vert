// Draws the scene's triangles into the G-buffer: world-space vertices to view and clip space, and to the view space of
// the previous frame. The triangle's material goes along: three reads a vertex in the place of three a pixel.
//
// A material is one row of material_table: base colour; metallic, roughness, flags (material_flags.glsl), alpha cutoff
// (negative: opaque); emissive, normal scale.
#version 450
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

layout(std140, binding = 0) uniform GbufferBlock {
  mat4 clip_from_view;
  mat4 view_from_world;
  mat4 previous_view_from_world;
  vec2 px_scale;
  float near_m;
};

layout(binding = 1) uniform sampler2D material_table;

layout(location = 0) in vec3 in_p_world;
layout(location = 1) in vec3 in_normal_world;
layout(location = 2) in vec4 in_tangent_world;
layout(location = 3) in vec2 in_uv;
layout(location = 4) in vec3 in_face_normal_world;
layout(location = 5) in float in_material_index;
layout(location = 6) in vec3 in_p_previous_world;

layout(location = 0) out vec3 p_view;
layout(location = 1) out vec3 normal_view;
layout(location = 2) out vec4 tangent_view;
layout(location = 3) out vec2 uv;
layout(location = 4) flat out vec3 face_normal_view;
layout(location = 5) flat out vec4 base_colour;
layout(location = 6) out vec3 p_previous_view;
layout(location = 7) flat out vec3 px_scale_and_near;  // a program has one block, and this stage has it
layout(location = 8) flat out vec4 surface;
layout(location = 9) flat out vec4 emissive_and_scale;

void main() {
  p_view = ordered_transform(view_from_world, vec4(in_p_world, 1.0)).xyz;
  normal_view = ordered_transform(view_from_world, vec4(in_normal_world, 0.0)).xyz;
  tangent_view = vec4(ordered_transform(view_from_world, vec4(in_tangent_world.xyz, 0.0)).xyz, in_tangent_world.w);
  uv = in_uv;
  face_normal_view = ordered_transform(view_from_world, vec4(in_face_normal_world, 0.0)).xyz;
  int row = int(in_material_index);
  base_colour = texelFetch(material_table, ivec2(0, row), 0);
  surface = texelFetch(material_table, ivec2(1, row), 0);
  emissive_and_scale = texelFetch(material_table, ivec2(2, row), 0);
  p_previous_view = ordered_transform(previous_view_from_world, vec4(in_p_previous_world, 1.0)).xyz;
  px_scale_and_near = vec3(px_scale, near_m);
  gl_Position = rasterizer_from_clip(ordered_transform(clip_from_view, vec4(p_view, 1.0)));
}
