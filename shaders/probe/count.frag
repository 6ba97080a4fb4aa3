// The start-up probe: counts in nested loops and tells how far it got.
//
// The software drivers of Mesa 22.3 leave every loop of a shader execution after 65,535 turns in all, without a word.
// The counts come from a block and each turn depends on the one before it, so that no compiler can work the answer
// out; the same shader with smaller counts is the load that the device's timer is held against.
#version 450

layout(binding = 0, std140) uniform Counts {
  uint outer_count;
  uint inner_count;
};

layout(location = 0) out vec2 count_and_hash;

void main() {
  uint hash = uint(gl_FragCoord.x);
  uint count = 0u;
  for (uint i = 0u; i < outer_count; ++i) {
    for (uint j = 0u; j < inner_count; ++j) {
      hash = hash * 1664525u + 1013904223u;
      count += 1u;
    }
  }
  count_and_hash = vec2(float(count), float(hash & 255u));
}
