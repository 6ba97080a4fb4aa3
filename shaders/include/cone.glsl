// The cone that a rough surface gathers its reflection from, and the circle in it at a hit.
//
// A lobe of reflected directions is replaced by a cone about the mirrored one, cut through its axis: an isosceles
// triangle of height h = t_m and base a = 2 t_m tan. What the lobe sees at the hit is the circle inscribed in it, of
// radius r = a (sqrt(a^2 + 4 h^2) - a) / 4h: Uludag, "Hi-Z Screen-Space Cone-Traced Reflections", GPU Pro 5, 2014;
// Hermanns and Franke, "Screen Space Cone Tracing for Glossy Reflections", SIGGRAPH 2014 posters. With a
// and h put in it is proportional to t_m, tan (sqrt(1 + tan^2) - tan) of it: 0 at contact instead of 0 / 0.
#ifndef CONE_GLSL
#define CONE_GLSL

// Tangent of the cone's half angle. Half of the normals that GGX draws lean less than atan(alpha) (Walter et al.,
// "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, equation 35, at its median), and a mirror turns
// what it reflects by twice its own lean: tan 2x = 2 tan x / (1 - tan^2 x). alpha is roughness^2.
float cone_tangent(float roughness) {
  const float LEAST = 0.05;  // a cone this wide, 88 degrees, is the hemisphere
  float alpha = roughness * roughness;
  return 2.0 * alpha / max(1.0 - alpha * alpha, LEAST);
}

// Radius of the inscribed circle for each metre along the ray: grows with the tangent, below 1/2. The root's conjugate
// has no difference that would cancel.
float cone_circle_per_m(float tangent) { return tangent / (sqrt(1.0 + tangent * tangent) + tangent); }

// Mip whose texels are as large as a circle of this radius in pixels: 0 up to half a pixel.
float circle_mip(float radius_px) { return log2(max(2.0 * radius_px, 1.0)); }

#endif
