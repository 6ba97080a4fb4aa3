// Light from the environment: prefiltered radiance by direction and roughness, irradiance, and the split sum.
//
// The including file defines load_environment. Directions are unit vectors in world space. The maps are octahedral, with
// a border of one texel (docs/techniques.md).
//   Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course "Physically Based Shading": the split sum
//   Meyer et al., "On Floating-Point Normal Vectors", EGSR 2010, section 3: the octahedron
#ifndef ENVIRONMENT_GLSL
#define ENVIRONMENT_GLSL

// The prefiltered radiance at one whole mip, bilinear.
vec3 load_environment(vec2 uv, float mip);

struct EnvironmentLayout {
  float side;  // texels a side of mip 0, border included; each mip has half as many
  float mip_count;
  float irradiance_side;
  float split_sum_side;
};

// Position on the unit square: +y in the middle, -y in the four corners.
vec2 octahedral_square(vec3 direction) {
  vec2 flat_square = vec2(direction.x, direction.z) / ((abs(direction.x) + abs(direction.y)) + abs(direction.z));
  vec2 outward = vec2(flat_square.x < 0.0 ? -1.0 : 1.0, flat_square.y < 0.0 ? -1.0 : 1.0);
  vec2 folded = (1.0 - vec2(abs(flat_square.y), abs(flat_square.x))) * outward;
  return 0.5 * (direction.y < 0.0 ? folded : flat_square) + 0.5;
}

// The border takes one texel on each side.
vec2 bordered_uv(vec2 square, float texel_uv) { return square + (1.0 - 2.0 * square) * texel_uv; }

// The mip, a fraction between two, for a perceptual roughness. Mip 0 is sharp; from the last, at roughness 1, each
// finer mip halves alpha. Below mip 1 a blend linear in roughness is nearest to the true blur of an edge.
float environment_mip(float roughness, float mip_count) {
  float last = mip_count - 1.0;
  float first_roughness = exp2(0.5 * (1.0 - last));
  return roughness < first_roughness ? roughness / first_roughness : last + 2.0 * log2(roughness);
}

vec3 environment_radiance(vec3 direction_world, float roughness, EnvironmentLayout maps) {
  vec2 square = octahedral_square(direction_world);
  float mip = clamp(environment_mip(roughness, maps.mip_count), 0.0, maps.mip_count - 1.0);
  float finer = floor(mip);
  float coarser = min(finer + 1.0, maps.mip_count - 1.0);
  float finer_texel_uv = exp2(finer) / maps.side;
  float coarser_texel_uv = exp2(coarser) / maps.side;
  return mix(load_environment(bordered_uv(square, finer_texel_uv), finer),
             load_environment(bordered_uv(square, coarser_texel_uv), coarser), mip - finer);
}

// Where the irradiance over pi of a surface with this normal is: what it reflects, were it white and Lambertian.
vec2 irradiance_uv(vec3 normal_world, EnvironmentLayout maps) {
  return bordered_uv(octahedral_square(normal_world), 1.0 / maps.irradiance_side);
}

// Where scale and bias are: F0 * scale + bias of a white environment is reflected. Columns are the root of the cosine,
// rows the roughness, from the middle of the first texel to the middle of the last.
vec2 split_sum_uv(float cos_view, float roughness, EnvironmentLayout maps) {
  vec2 position = vec2(sqrt(cos_view), roughness) * (maps.split_sum_side - 1.0) + 0.5;
  return position / maps.split_sum_side;
}

#endif
