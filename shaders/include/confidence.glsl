// How far a reflection that was found on the screen is to be trusted, as factors of 0..1 that are multiplied.
//
// Each factor hides one limit of screen space before it shows as a hard edge: what lies beyond the image, beyond the
// ray's reach, on the far side of a surface, behind the camera, or beyond the budget. Each is 1 far from its limit and
// monotone; all but back_face_weight, which tells a wrong answer from a right one, are continuous and 0 at the limit.
// Purpose: weighs a hit. Undefined on a miss: a miss has confidence 0 before any factor.
#ifndef CONFIDENCE_GLSL
#define CONFIDENCE_GLSL

#include "ssr_ordered.glsl"

// 0 up to x = 0, 1 from x = 1 on, with no kink at either end (the cubic Hermite polynomial).
float smooth_rise(float x) {
  float clamped = clamp(x, 0.0, 1.0);
  return clamped * clamped * (3.0 - 2.0 * clamped);
}

// 0 on the image's border, 1 from border_fraction of the image's size inwards; a fraction of 0 never fades.
// By the hit: it is the hit's surroundings that the image lacks. The receiver's own place says nothing of them.
float edge_fade(vec2 hit_px, vec2 size_px, float border_fraction) {
  const float LEAST_FRACTION = 1e-6;  // far less than half a texel of the largest image
  vec2 inwards = min(hit_px, size_px - hit_px) / (size_px * max(border_fraction, LEAST_FRACTION));
  return smooth_rise(inwards.x) * smooth_rise(inwards.y);
}

// 1 at the receiver, 0 at reach_m and beyond; the square keeps what is near, where reflections are looked at.
float distance_fade(float t_m, float reach_m) {
  float fraction = t_m / reach_m;
  return clamp(1.0 - fraction * fraction, 0.0, 1.0);
}

// 0 where the ray comes from behind the surface that it hit: the camera sees the other side.
float back_face_weight(vec3 normal_view_hit, vec3 dir_view) {
  return ordered_dot(normal_view_hit, dir_view) > 0.0 ? 0.0 : 1.0;
}

// towards_camera is the cosine between the ray and the direction to the camera's plane, dir_view.z. Rays that come back
// to the camera see the sides of things that it cannot see. 1 up to fade_start, 0 from fade_end on.
float facing_fade(float towards_camera, float fade_start, float fade_end) {
  return 1.0 - smooth_rise((towards_camera - fade_start) / (fade_end - fade_start));
}

// 1 at the first lookups, 0 where limit is spent. The eighth power keeps all but the last of the budget whole (Deliot,
// "OpenGL engine and PBR deferred pipeline with SSR/SSAO", 2018).
float budget_fade(float lookups, float limit) {
  float fraction = clamp(lookups / limit, 0.0, 1.0);
  float squared = fraction * fraction;
  float fourth = squared * squared;
  return 1.0 - fourth * fourth;
}

#endif
