// The depth and the normal as a peer's shader expects them.
//
// In:  dist_view, normal_view. Out: peer_depth, peer_normal (a: the kit's clearance, unchanged).
#version 450
#include "peer_conventions.glsl"

layout(std140, binding = 0) uniform PeerInputsBlock {
  float near_m;
  float far_m;
  int peer_depth_form;
  int peer_normal_form;
};

layout(binding = 1) uniform sampler2D dist_view;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out float peer_depth;
layout(location = 1) out vec4 peer_normal;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 normal_and_clearance = texelFetch(normal_view, texel, 0);
  peer_depth = peer_depth_of(texelFetch(dist_view, texel, 0).x, near_m, far_m, peer_depth_form);
  peer_normal = vec4(peer_normal_of(normal_and_clearance.xyz, peer_normal_form), normal_and_clearance.a);
}
