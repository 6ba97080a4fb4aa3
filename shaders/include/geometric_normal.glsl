// The normal of the surface itself at a texel, from the depths around it; a normal map does not bend it.
//
// Purpose: the slope of a surface against a light. The G-buffer's normal_view is the shading normal, which on a facet
//   of a sphere, or under a normal map, is another plane than the one that was drawn.
// Needs: float load_dist_view(vec2 texel), metres, +inf for background.
// In: the texel's own position and shading normal. Out: unit, towards the camera. Where the neighbours on two sides
//   do not lie on one line with the texel, as at an edge, before the sky or on a pole one texel wide, it is the
//   shading normal; also where the result is farther off than normal maps bend. At the image's border the one
//   neighbour there is is believed.
#ifndef GEOMETRIC_NORMAL_GLSL
#define GEOMETRIC_NORMAL_GLSL

#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

const float GEOMETRIC_NORMAL_LINE = 0.99;   // cosine between the two sides: 8 degrees
const float GEOMETRIC_NORMAL_TRUST = 0.85;  // cosine to the shading normal: 32 degrees

// Zero where the texel is background.
vec3 direction_to_texel(vec3 p_view, vec2 beside, PixelProjection projection) {
  float dist = load_dist_view(beside);
  bool is_background = isinf(dist);
  vec3 direction = position_px_to_view(beside + 0.5, is_background ? 1.0 : dist, projection) - p_view;
  return is_background ? vec3(0.0) : ordered_normalize(direction);
}

// The surface's direction along one axis of the image; zero where there is none.
vec3 direction_along(vec3 p_view, vec2 texel, vec2 axis, PixelProjection projection, vec2 size_px) {
  bool has_before = ordered_dot(texel, axis) >= 1.0;
  bool has_after = ordered_dot(texel - size_px, axis) < -1.5;
  vec3 after = direction_to_texel(p_view, texel + (has_after ? axis : -axis), projection);
  vec3 before = direction_to_texel(p_view, texel - (has_before ? axis : -axis), projection);
  after = has_after ? after : -after;
  before = has_before ? before : -before;
  bool is_line = (has_before || has_after) && -ordered_dot(before, after) > GEOMETRIC_NORMAL_LINE;
  return is_line ? after - before : vec3(0.0);
}

vec3 geometric_normal(vec3 p_view, vec3 normal_view, vec2 texel, PixelProjection projection, vec2 size_px) {
  vec3 along_x = direction_along(p_view, texel, vec2(1.0, 0.0), projection, size_px);
  vec3 along_y = direction_along(p_view, texel, vec2(0.0, 1.0), projection, size_px);
  vec3 crossed = cross(along_y, along_x);  // p_px grows downwards: this order points at the camera
  vec3 normal = crossed / sqrt(max(ordered_dot(crossed, crossed), 1e-20));
  return ordered_dot(normal, normal_view) < GEOMETRIC_NORMAL_TRUST ? normal_view : normal;
}

#endif
