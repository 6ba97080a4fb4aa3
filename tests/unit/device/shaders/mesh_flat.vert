#version 450

layout(location = 0) in vec3 position_ndc;
layout(location = 1) in float shade_in;

layout(location = 0) flat out float shade;

void main() {
  shade = shade_in;
  gl_Position = vec4(position_ndc, 1.0);
}
