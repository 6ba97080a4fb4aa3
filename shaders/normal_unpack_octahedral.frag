// Reads octahedral normals back into the form that the tracers read.
//
// In: normal_octahedral; normal_view for its alpha alone (the clearance, which a packed G-buffer keeps elsewhere).
// Out: normal_unpacked, xyz unit, a clearance.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform isampler2D normal_octahedral;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out vec4 normal_unpacked;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 normal = normal_from_octahedral(texelFetch(normal_octahedral, texel, 0).xy);
  normal_unpacked = vec4(normal, texelFetch(normal_view, texel, 0).a);
}
