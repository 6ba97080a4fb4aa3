// Motion of a surface point on the image, and where points were in the previous frame.
//
// Purpose: reprojection. A point that is at p_px in this frame was at p_px - motion in the previous one.
// In: view positions, each in its own frame's camera space. Out: pixels, or positions in the previous view space.
// A point that was not before the previous camera's near plane has no place on that image: its motion is +inf, so that
//   p_px - motion lies outside of every image and no test but the one against the image's edges is needed.
// Static is exact: equal positions give a motion of 0, and a previous_view_from_view that is the identity changes no
//   bit. `precise` keeps it so: else a compiler may simplify (a + b) - a on the way to one of the two positions only.
#ifndef SSR_MOTION_GLSL
#define SSR_MOTION_GLSL

#include "ssr_ordered.glsl"

float no_motion() { return uintBitsToFloat(0x7F800000u); }  // +inf

// px_scale as in ssr_spaces.glsl; px_offset is the same in both frames and falls out.
vec2 motion_px(vec3 p_view, vec3 p_previous_view, vec2 px_scale, float near_m) {
  precise vec2 now = px_scale * (p_view.xy / -p_view.z);
  precise vec2 previous = px_scale * (p_previous_view.xy / -p_previous_view.z);
  return -p_previous_view.z < near_m ? vec2(no_motion()) : now - previous;
}

struct PreviousFrame {
  mat4 previous_view_from_view;
  vec2 px_scale;
  float near_m;
};

// Where the point was if it stands still in the world.
vec3 still_previous_view(vec3 p_view, PreviousFrame frame) {
  return (frame.previous_view_from_view * vec4(p_view, 1.0)).xyz;
}

// The part of a surface point's motion that is its own, not the camera's; 0 for what stands still in the world.
vec2 own_motion_px(vec3 p_view, vec2 motion, PreviousFrame frame) {
  return motion - motion_px(p_view, still_previous_view(p_view, frame), frame.px_scale, frame.near_m);
}

// Where the point was when it moves by `own_px` on its own. Two numbers say nothing of a motion along the viewing
// direction: the distance is that of a point that stands still.
vec3 moved_previous_view(vec3 p_view, vec2 own_px, PreviousFrame frame) {
  precise vec3 still = still_previous_view(p_view, frame);
  precise vec2 moved = still.xy + own_px * still.z / frame.px_scale;
  return vec3(moved, still.z);
}

// The image of a point in a plane mirror.
vec3 mirror_image(vec3 p_view, vec3 p_mirror_view, vec3 normal) {
  precise vec3 from_mirror = p_view - p_mirror_view;
  precise vec3 image = p_view - (2.0 * ordered_dot(normal, from_mirror)) * normal;
  return image;
}

#endif
