// Mutant of ao.frag: see ao_without_plane.toml.
#version 450
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

layout(std140, binding = 0) uniform AoBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  float near_m;
  float ao_radius_m;
  float ao_thickness_m;
  int ao_sample_count;
};

layout(binding = 1) uniform sampler2D dist_view;
layout(binding = 2) uniform sampler2D normal_view;

layout(location = 0) out vec2 ao_noisy;

// A nearest sample instead of texelFetch: the same texel, and 1.7 times as fast on llvmpipe.
float load_dist_view(vec2 texel) { return textureLod(dist_view, (texel + 0.5) * texel_uv, 0.0).x; }

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
  return is_inside && depth_inside > 0.0 ? column : 0.0;
}

float ambient_visibility(vec3 p_view, vec3 normal, vec3 noise, PixelProjection projection, AoParameters parameters) {
  vec3 tangent;
  vec3 bitangent;
  ao_frame(normal, tangent, bitangent);
  vec2 around = vec2(cos(AO_TAU * noise.x), sin(AO_TAU * noise.x));
  float covered = 0.0;
  float per_sample = 1.0 / float(parameters.sample_count);
  for (int i = 0; i < parameters.sample_count; ++i) {
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

// 0 to 15 over 4 x 4 pixels: two bits of x and y interleaved, so that near numbers are apart (a Bayer matrix).
float pattern_index(ivec2 texel) {
  int x = texel.x & 3;
  int y = texel.y & 3;
  int crossed = x ^ y;
  return float((crossed & 1) * 8 + (y & 1) * 4 + (crossed >> 1) * 2 + (y >> 1));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float dist = texelFetch(dist_view, texel, 0).x;
  if (isinf(dist)) {
    ao_noisy = vec2(1.0, dist);
    return;
  }
  PixelProjection projection = PixelProjection(px_scale, px_offset, view_per_px);
  vec3 p_view = position_px_to_view(vec2(texel) + 0.5, dist, projection);
  vec3 normal = ordered_normalize(texelFetch(normal_view, texel, 0).xyz);
  float index = pattern_index(texel);
  vec3 noise = fract((vec3(1.0, 7.0, 5.0) * index + 0.5) / 16.0);  // sixteen different ones of each
  AoParameters parameters = AoParameters(ao_radius_m, ao_thickness_m, ao_sample_count, size_px, near_m);
  ao_noisy = vec2(ambient_visibility(p_view, normal, noise, projection, parameters), dist);
}
