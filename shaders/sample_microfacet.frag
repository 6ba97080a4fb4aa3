// Draws one visible microfacet of each rough pixel for the tracer to reflect its ray at.
//
// In:  normal_view, material (g roughness). sample_index of sample_count; point_set (random.glsl). Each
//      frame turns its points on by the next of a sequence (frame_turn), so that frames put together sample anew.
// Out: microfacet_normal, in the layout of normal_view; its bits where the surface is a mirror.
#version 450
#include "microfacet.glsl"
#include "random.glsl"

layout(std140, binding = 0) uniform SampleBlock {
  vec2 px_offset;
  vec2 view_per_px;
  int sample_index;
  int sample_count;
  int frame_index;
  int point_set;
};

layout(binding = 1) uniform sampler2D normal_view;
layout(binding = 2) uniform sampler2D material;
layout(binding = 3) uniform sampler2D blue_noise;

layout(location = 0) out vec4 microfacet_normal;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec2 mask = texelFetch(blue_noise, texel & (BLUE_NOISE_SIDE - 1), 0).xy;
  vec2 turn = frame_turn(mask, frame_index);
  vec2 point = pixel_point(texel, sample_index, sample_count, point_set, turn);
  float roughness = texelFetch(material, texel, 0).g;
  microfacet_normal = microfacet_of(texelFetch(normal_view, texel, 0), from_eye, roughness, point);
}
