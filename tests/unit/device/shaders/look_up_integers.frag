#version 450

layout(binding = 0) uniform isampler2D signed_image;
layout(binding = 1) uniform usampler2D unsigned_image;

layout(location = 0) out vec4 result;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  result = vec4(texelFetch(signed_image, texel, 0).xy, texelFetch(unsigned_image, texel, 0).xw);
}
