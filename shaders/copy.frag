// Copies an image, mip 0 to mip 0. In: source. Out: the copy.
#version 450

layout(binding = 1) uniform sampler2D source;

layout(location = 0) out vec4 copied;

void main() { copied = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }
