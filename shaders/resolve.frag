// Fetches what each ray hit: the lit colour of the hit texel.
//
// The texel, not the hit position: a silhouette entered from the side puts the position on the texel's edge, where its
// floor is off by one. Out: reflection, rgb linear radiance, a = 1 where the ray hit; zero elsewhere.
#version 450

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D lit;

layout(location = 0) out vec4 reflection;

void main() {
  ivec2 hit = texelFetch(hit_texel, ivec2(gl_FragCoord.xy), 0).xy;
  reflection = hit.x >= 0 ? vec4(texelFetch(lit, hit, 0).rgb, 1.0) : vec4(0.0);
}
