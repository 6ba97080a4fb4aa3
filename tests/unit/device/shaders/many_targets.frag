// One target of each kind; the integers sit at the ends of their ranges.
#version 450

layout(location = 0) out vec4 floats;
layout(location = 1) out ivec2 signed_integers;
layout(location = 2) out uvec4 unsigned_integers;
layout(location = 3) out uint byte_value;

void main() {
  floats = vec4(0.1, -2.0, 3.0e30, 4.0);
  signed_integers = ivec2(-32768, 32767) + ivec2(int(gl_FragCoord.x), 0);
  unsigned_integers = uvec4(0u, 1u, 65534u, 65535u);
  byte_value = 200u + uint(gl_FragCoord.y);
}
