// Reads octahedral normals back into the form that the tracers read.
//
// In: normal_octahedral; normal_view for its alpha alone (the clearance, which a packed G-buffer keeps elsewhere).
// Out: normal_unpacked, xyz unit, a clearance; xyz 0 for background.
#version 450
#include "normal_encoding.glsl"

layout(binding = 1) uniform isampler2D normal_octahedral;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out vec4 normal_unpacked;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 stored = texelFetch(normal_octahedral, texel, 0).xy;
  vec3 normal = stored.x == SNORM16_NONE ? vec3(0.0) : normal_from_octahedral(stored);
  normal_unpacked = vec4(normal, texelFetch(normal_view, texel, 0).a);
}
