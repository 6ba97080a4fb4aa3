// Depth of casters with an alpha cutoff: texels below it are not there, as in gbuffer.frag.
//
// Out: depth alone.
#version 450

layout(binding = 2) uniform sampler2D base_colour_texture;

layout(location = 0) in vec2 uv;
layout(location = 1) flat in vec3 alpha;

void main() {
  float sampled_alpha = alpha.z > 0.0 ? alpha.x * texture(base_colour_texture, uv).a : alpha.x;
  if (sampled_alpha < alpha.y) {
    discard;
  }
}
