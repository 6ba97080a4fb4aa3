// What arithmetic costs, as a loop that nothing can shorten: its result follows from its arguments, which no compiler
// knows.
#ifndef ROOFLINE_ALU_GLSL
#define ROOFLINE_ALU_GLSL

// `count` times x * scale + add, from 0, in four lanes that do not wait for each other. Returns their mean: with scale 1
// it is count * add.
float roofline_arithmetic(float scale, float add, int count) {
  vec4 lanes = vec4(0.0);
  for (int i = 0; i < count; ++i) {
    lanes = lanes * scale + add;
  }
  return 0.25 * ((lanes.x + lanes.y) + (lanes.z + lanes.w));
}

#endif
