#version 450

layout(location = 0) flat in float shade;
layout(location = 0) out float result;

void main() { result = shade; }
