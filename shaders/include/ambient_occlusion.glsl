// Ambient obscurance by points in the hemisphere over a pixel.
//
// Points are strewn over the half ball about the surface's normal, as many in each direction as its cosine says,
// evenly from the centre to radius_m. A point is covered when it lies in a column of the depth image: behind the
// depth Z of its texel, and before Z + T (Mittring, "Finding Next Gen: CryEngine 2", SIGGRAPH 2007 course, section
// 8.5.4.3; the half ball: Filion and McNaughton, "Effects & Techniques", SIGGRAPH 2008 course, StarCraft II). The
// share of points that are not covered is, in the mean,
//   1 - 1/pi * integral over the hemisphere of max(0, 1 - distance(w) / radius_m) * cos w  dw
// with distance(w) that of the first surface: obscurance with a linear fall-off (Zhukov, Iones and Kronin, "An Ambient
// Light Illumination Model", 1998). On the edge of a right angle it is 1/2, for two endless walls whatever the radius.
// - Only what rises over the pixel's tangent plane can cover: a texel's point within AO_PLANE_SINE of the plane never
//   does, so a plane is exactly 1 from any angle, and the facets of a sphere do not shade each other (after the angle
//   bias of Bavoil et al., "Image-Space Horizon-Based Ambient Occlusion", SIGGRAPH 2008 talk).
// - A column is as thick as thickness_m, then fades over as much again: what stands far before the pixel casts no halo.
// - Points outside the image, or before the near plane, are not covered: nothing is known of them.
// Needs: GL_EXT_control_flow_attributes; float load_dist_view(vec2 texel), metres, +inf for background.
// In: view position and unit normal of a texel's centre; `noise`, three numbers of 0 to 1 that differ from pixel to
//   pixel and turn, spread and stretch the points.
#ifndef AMBIENT_OCCLUSION_GLSL
#define AMBIENT_OCCLUSION_GLSL

#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

const float AO_PLANE_SINE = 0.05;       // 2.9 degrees
const float AO_FARTHEST_M = 1e15;       // stands for background: squares stay finite
const float AO_TAU = 6.28318530717959;
// Cosine and sine of the golden angle: turning by it again and again spreads directions evenly (Vogel, "A Better Way to
// Construct the Sunflower Head", Mathematical Biosciences 44, 1979).
const vec2 AO_GOLDEN = vec2(-0.737368878078320, 0.675490294261524);
const float AO_DISTANCE_STEP = 0.754877666246693;  // 1 / the plastic number: unrelated to the golden angle

struct AoParameters {
  float radius_m;
  float thickness_m;
  int sample_count;
  vec2 size_px;
  float near_m;
};

// Two directions that make a right-handed frame with the normal (Duff et al., "Building an Orthonormal Basis,
// Revisited", JCGT 6(1) 2017).
void ao_frame(vec3 normal, out vec3 tangent, out vec3 bitangent) {
  float side = normal.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + normal.z);
  float b = normal.x * normal.y * a;
  tangent = vec3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x);
  bitangent = vec3(b, side + normal.y * normal.y * a, -normal.y);
}

// How much of one point is covered: 0 to 1.
float ao_covered(vec3 point_view, vec3 p_view, vec3 normal, PixelProjection projection, AoParameters parameters) {
  float dist = -point_view.z;
  vec2 texel = floor(position_view_to_px(vec3(point_view.xy, -max(dist, parameters.near_m)), projection));
  bool is_inside = dist > parameters.near_m && all(greaterThanEqual(texel, vec2(0.0))) &&
                   all(lessThan(texel, parameters.size_px));
  float surface_dist = min(load_dist_view(clamp(texel, vec2(0.0), parameters.size_px - 1.0)), AO_FARTHEST_M);
  vec3 to_surface = position_px_to_view(texel + 0.5, surface_dist, projection) - p_view;
  float rise = ordered_dot(to_surface, normal);
  bool rises = rise > 0.0 && rise * rise > (AO_PLANE_SINE * AO_PLANE_SINE) * ordered_dot(to_surface, to_surface);
  float depth_inside = dist - surface_dist;
  float column = clamp(2.0 - depth_inside / parameters.thickness_m, 0.0, 1.0);
  return is_inside && rises && depth_inside > 0.0 ? column : 0.0;
}

float ambient_visibility(vec3 p_view, vec3 normal, vec3 noise, PixelProjection projection, AoParameters parameters) {
  vec3 tangent;
  vec3 bitangent;
  ao_frame(normal, tangent, bitangent);
  vec2 around = vec2(cos(AO_TAU * noise.x), sin(AO_TAU * noise.x));
  float covered = 0.0;
  float per_sample = 1.0 / float(parameters.sample_count);
  // Written out where the count is a constant.
  [[unroll]] for (int i = 0; i < parameters.sample_count; ++i) {
    // Malley: points even over the unit disc, lifted onto the hemisphere, are distributed as the cosine.
    float disc_radius_squared = (float(i) + noise.y) * per_sample;
    vec2 disc = sqrt(disc_radius_squared) * around;
    vec3 direction = disc.x * tangent + disc.y * bitangent + sqrt(1.0 - disc_radius_squared) * normal;
    float distance_m = fract(noise.z + AO_DISTANCE_STEP * float(i)) * parameters.radius_m;
    covered += ao_covered(p_view + distance_m * direction, p_view, normal, projection, parameters);
    around = vec2(around.x * AO_GOLDEN.x - around.y * AO_GOLDEN.y, around.x * AO_GOLDEN.y + around.y * AO_GOLDEN.x);
  }
  return 1.0 - covered * per_sample;
}

#endif
