// Asks for a level that differs from texel to texel: the size and the value of that level of `pyramid`.
#version 450

layout(binding = 0) uniform sampler2D pyramid;

layout(location = 0) out vec2 size_and_value;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  int level = (texel.x + texel.y) & 1;
  size_and_value = vec2(float(textureSize(pyramid, level).x), texelFetch(pyramid, ivec2(0), level).x);
}
