// Which of two neighbouring rays started from the surface that a texel between them sees: the range weights of joint
// bilateral upsampling (Kopf, Cohen, Lischinski and Uyttendaele, "Joint Bilateral Upsampling", SIGGRAPH 2007, equation 3).
//
// In: dist_view of the texel and of the origins of two rays of which it is the middle on the image; NO_RAY_M without one.
// Out: the rays' weights, 0 or 1.
// The guide is the plane. On a plane 1 / dist_view is linear on the image, so the three lie on one plane, whatever its
// normal, where the texel's is the mean of the others': a floor at a grazing angle is one surface although neighbouring
// texels lie metres apart. Then both rays count; else an edge or a crease lies between, and the one counts whose
// 1 / dist_view is nearer. Nothing bleeds over an edge, and beside a crease at most one texel is taken for its neighbour.
// Products instead of quotients: with x = b (a - d) and y = a (b - d), 1/d - 1/a = x / (a b d) and 1/d - 1/b = y / (a b d).
#ifndef JOINT_BILATERAL_GLSL
#define JOINT_BILATERAL_GLSL

const float NO_RAY_M = 1e15;  // its square is finite

// How far the texel may be from the plane, along the viewing direction and in pixels' widths at its own distance:
// rounding, and the curve of a sphere. px_m_per_m is a pixel's width at 1 m.
const float ONE_PLANE_PX = 0.05;

vec2 same_surface_weights(float dist, float dist_a, float dist_b, float px_m_per_m) {
  float off_a = dist_b * (dist_a - dist);
  float off_b = dist_a * (dist_b - dist);
  bool on_one_plane = abs(off_a + off_b) <= (2.0 * ONE_PLANE_PX * px_m_per_m) * (dist_a * dist_b);
  bool is_a_nearer = abs(off_a) <= abs(off_b);
  return vec2(on_one_plane || is_a_nearer, on_one_plane || !is_a_nearer);
}

#endif
