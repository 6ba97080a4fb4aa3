// turn_count dependent turns a texel: a load to be timed.
#version 450

layout(binding = 0, std140) uniform Load { uint turn_count; };

layout(location = 0) out vec4 result;

void main() {
  uint hash = uint(gl_FragCoord.x);
  for (uint i = 0u; i < turn_count; ++i) {
    hash = hash * 1664525u + 1013904223u;
  }
  result = vec4(float(hash));
}
