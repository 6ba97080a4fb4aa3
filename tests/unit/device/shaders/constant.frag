#version 450

layout(binding = 0, std140) uniform Colour { vec4 colour; };

layout(location = 0) out vec4 result;

void main() { result = colour; }
