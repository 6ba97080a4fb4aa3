// A shading normal fit for lighting.
#ifndef UNIT_NORMAL_GLSL
#define UNIT_NORMAL_GLSL
#include "ssr_ordered.glsl"

// A normal without a direction, as degenerate triangles have, faces the viewer; so does one that is no number.
vec3 unit_normal(vec3 normal, vec3 to_eye) {
  float length2 = ordered_dot(normal, normal);
  return length2 > 1e-12 ? normal / sqrt(length2) : to_eye;
}

#endif
