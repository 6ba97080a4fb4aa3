// The background: a gradient from the horizon's colour to the zenith's, darker ground below.
#ifndef SKY_GLSL
#define SKY_GLSL

// elevation is the sine of the direction's angle above the horizon.
vec3 sky_radiance(float elevation, vec3 horizon, vec3 zenith) {
  float up = sqrt(clamp(elevation, 0.0, 1.0));
  float down = clamp(-4.0 * elevation, 0.0, 1.0);
  return mix(mix(horizon, zenith, up), 0.35 * horizon, down);
}

#endif
