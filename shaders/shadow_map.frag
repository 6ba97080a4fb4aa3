// Depth of what the light sees. The rule is the G-buffer's own (gbuffer.frag), with the light in the camera's place: a
// single-sided triangle is there from its front only, a double-sided one from both, and texels below the alpha cutoff
// are not there. So a room's inward-facing wall lets light in from outside, as it lets the camera look in.
//
// Out: depth alone.
#version 450

layout(binding = 1) uniform sampler2D material_table;
layout(binding = 2) uniform sampler2D base_colour_texture;

layout(location = 0) in vec2 uv;
layout(location = 1) flat in float facing;
layout(location = 2) flat in float material_index;

void main() {
  int row = int(material_index);
  float alpha = texelFetch(material_table, ivec2(0, row), 0).a;
  float alpha_cutoff = texelFetch(material_table, ivec2(1, row), 0).a;  // negative: opaque
  bool has_texture = texelFetch(material_table, ivec2(3, row), 0).x > 0.0;
  bool is_double_sided = texelFetch(material_table, ivec2(4, row), 0).x > 0.0;
  float sampled_alpha = has_texture ? alpha * texture(base_colour_texture, uv).a : alpha;
  if ((facing <= 0.0 && !is_double_sided) || sampled_alpha < alpha_cutoff) {
    discard;
  }
}
