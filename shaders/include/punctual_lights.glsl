// Falloff of point and spot lights: inverse square with a smooth end at the range, and a smooth cone.
// Khronos, "KHR_lights_punctual", sections "Range Property" and "Inner and Outer Cone Angles".
#ifndef PUNCTUAL_LIGHTS_GLSL
#define PUNCTUAL_LIGHTS_GLSL

// range_m 0: unlimited. cone_cosine: between the light's axis and the direction to the surface; outer -1: no cone.
// Nearer than a centimetre the inverse square stops rising: a light on a surface stays finite.
float punctual_falloff(float distance_m, float range_m, float cone_cosine, float inner, float outer) {
  float reach = range_m > 0.0 ? clamp(1.0 - pow(distance_m / range_m, 4.0), 0.0, 1.0) : 1.0;
  float spot = outer <= -1.0 ? 1.0 : clamp((cone_cosine - outer) / max(inner - outer, 1e-4), 0.0, 1.0);
  return reach * spot * spot / max(distance_m * distance_m, 1e-4);
}

#endif
