// A std140 block with the members that padding moves about.
#version 450

layout(binding = 2, std140) uniform Block {
  vec3 first;
  float second;
  ivec2 third;
  mat4 matrix;
  uint last;
};

layout(location = 0) out vec4 firsts;
layout(location = 1) out vec4 column;

void main() {
  firsts = vec4(first.z, second, float(third.y), float(last));
  column = matrix * vec4(0.0, 0.0, 1.0, 0.0);
}
