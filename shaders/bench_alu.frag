// A roofline: arithmetic without memory.
//
// Out: roofline, the mean of the lanes.
#version 450

layout(std140, binding = 0) uniform RooflineBlock {
  float roofline_scale;
  float roofline_add;
  int roofline_count;
};

layout(location = 0) out float roofline;

#include "roofline_alu.glsl"

void main() { roofline = roofline_arithmetic(roofline_scale, roofline_add, roofline_count); }
