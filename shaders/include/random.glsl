// Random numbers and well-spread points, the same bits on every device: integer arithmetic and exact scalings only.
//
// A pixel's samples are points of the unit square, chosen by `point_set`:
//   POINTS_WHITE             independent points from a hash: the baseline
//   POINTS_HAMMERSLEY        the Hammersley set of sample_count points, turned by a hash of the pixel
//   POINTS_HAMMERSLEY_BLUE   the same set, turned by the pixel's value of a mask of blue noise, which differs from its
//                            neighbours' as much as it can, so that what error is left goes away under a small blur
// Hash: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3) 2020, pcg3d. Rotation: Cranley and
// Patterson, "Randomization of Number Theoretic Methods for Multiple Integration", SIAM J. Numer. Anal. 13(6) 1976.
#ifndef RANDOM_GLSL
#define RANDOM_GLSL

const int POINTS_WHITE = 0;
const int POINTS_HAMMERSLEY = 1;
const int POINTS_HAMMERSLEY_BLUE = 2;

const int BLUE_NOISE_SIDE = 64;  // texels of the mask, which tiles

uvec3 hash_pcg3d(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// 0..1, 1 excluded: the upper 24 bits, which a float holds exactly.
vec3 unit_from_bits(uvec3 bits) { return vec3(bits >> 8u) * (1.0 / 16777216.0); }

vec3 white_noise(ivec2 texel, int index) { return unit_from_bits(hash_pcg3d(uvec3(texel, index))); }

// The bits of index mirrored at the binary point (van der Corput), by swapping ever larger halves.
float radical_inverse_2(uint index) {
  uint bits = (index << 16u) | (index >> 16u);
  bits = ((bits & 0x00ff00ffu) << 8u) | ((bits & 0xff00ff00u) >> 8u);
  bits = ((bits & 0x0f0f0f0fu) << 4u) | ((bits & 0xf0f0f0f0u) >> 4u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xccccccccu) >> 2u);
  bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xaaaaaaaau) >> 1u);
  return float(bits >> 8u) * (1.0 / 16777216.0);
}

// Point `index` of `count`. The half keeps point 0 off the square's edge.
vec2 hammersley(int index, int count) {
  return vec2((float(index) + 0.5) / float(count), radical_inverse_2(uint(index)));
}

// `by` moved on for each frame by the additive sequence of the plastic number, which covers the square evenly
// (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018). Frame 0 changes no bit.
vec2 frame_turn(vec2 by, int frame_index) { return by + float(frame_index) * vec2(0.7548776662, 0.5698402910); }

vec2 rotated(vec2 point, vec2 by) {
  vec2 sum = point + by;
  return sum - floor(sum);
}

// Sample `index` of the `count` of a pixel; mask is its texel of the mask of blue noise.
vec2 pixel_point(ivec2 texel, int index, int count, int point_set, vec2 mask) {
  vec2 white = white_noise(texel, index).xy;
  vec2 own_turn = white_noise(texel, 0).xy;
  vec2 regular = rotated(hammersley(index, count), point_set == POINTS_HAMMERSLEY ? own_turn : mask);
  return point_set == POINTS_WHITE ? white : regular;
}

#endif
