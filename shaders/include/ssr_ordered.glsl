// Sums of products written out in one order.
//
// Purpose: drivers are free to sum dot(), normalize() and reflect() in any order, and do; written out, every device
//   gives the same bits (docs/precision.md). Everything that decides where a ray goes uses these forms.
#ifndef SSR_ORDERED_GLSL
#define SSR_ORDERED_GLSL

float ordered_dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }

float ordered_dot(vec3 a, vec3 b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

// m * v.
vec4 ordered_transform(mat4 m, vec4 v) { return ((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3] * v.w; }

vec3 ordered_normalize(vec3 v) { return v / sqrt(ordered_dot(v, v)); }

// incident points towards the surface; normal is a unit vector.
vec3 ordered_reflect(vec3 incident, vec3 normal) { return incident - (2.0 * ordered_dot(normal, incident)) * normal; }

#endif
