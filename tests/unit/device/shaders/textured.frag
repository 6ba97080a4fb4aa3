#version 450

layout(binding = 4) uniform sampler2D factor;

layout(location = 0) in float shade;
layout(location = 0) out float result;

void main() { result = shade * textureLod(factor, vec2(0.5), 0.0).r; }
