// What a pixel may take from its neighbours' rays, and how much each counts.
//
// A neighbour's ray ends where it ends for this pixel too, seen along another direction. As a sample of this pixel's
// own integral it counts brdf * cosine here over the density that the neighbour drew it with; divided by the sum of
// these weights the noise that brdf / density brings cancels (Stachowiak, "Stochastic Screen-Space Reflections",
// SIGGRAPH 2015 course Advances in Real-Time Rendering, slides on "Ray reuse": a ratio estimator, biased by what it
// cancels).
#ifndef RAY_REUSE_GLSL
#define RAY_REUSE_GLSL

#include "microfacet.glsl"

const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);  // of linear sRGB

// Density per steradian of the direction that reflection at a visible microfacet gives, in the frame of the normal:
// D_V / (4 to_eye . half_vector) = G1 D / (4 to_eye.z).
float reflected_density(vec3 to_eye, vec3 half_vector, float alpha) {
  float g1 = 1.0 / (1.0 + smith_lambda(to_eye, alpha));
  return g1 * distribution_in_frame(half_vector, alpha) / (4.0 * to_eye.z);
}

// brdf * cosine without Fresnel: D G2 / (4 to_eye.z). 0 for directions below the surface.
float lobe_times_cosine(vec3 to_eye, vec3 to_light, float alpha) {
  if (to_light.z <= 0.0) {
    return 0.0;
  }
  vec3 half_vector = ordered_normalize(to_eye + to_light);
  return reflected_density(to_eye, half_vector, alpha) * unshadowed_share(to_eye, to_light, alpha);
}

#endif
