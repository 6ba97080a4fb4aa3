// The second half of INF584's pair of buffers: beside where each ray ended (hit_texel) how visible its reflection is.
//
// In:  hit_texel, albedo, material, reflection (a: confidence). Out: visibility, 0 on a miss.
// A Blinn-Phong surface has one specular number; of a metallic-roughness one it is the largest part of its reflectance.
#version 450
#include "composite_forms.glsl"

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D albedo;
layout(binding = 3) uniform sampler2D material;
layout(binding = 4) uniform sampler2D reflection;

layout(location = 0) out float visibility;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  if (texelFetch(hit_texel, texel, 0).x < 0) {
    visibility = 0.0;
    return;
  }
  vec4 surface = texelFetch(material, texel, 0);
  vec3 f0 = fresnel_f0(texelFetch(albedo, texel, 0).rgb, surface.r);
  float specular = max(max(f0.r, f0.g), f0.b);
  visibility = specular_visibility(specular, shininess_of(surface.g)) * texelFetch(reflection, texel, 0).a;
}
