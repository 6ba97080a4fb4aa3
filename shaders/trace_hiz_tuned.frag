// Traces every reflective pixel's ray through the min-depth pyramid, tuned form: all levels in one atlas.
#version 450
#include "trace_entry.glsl"

layout(binding = 4) uniform sampler2D pyramid_atlas;

// Copies of the block's members (trace_entry.glsl).
vec2 atlas_uv = atlas_texel_uv;
float atlas_height = atlas_rows;

// 1 / a power of two, exactly, by the exponent alone: a division in the loop is 0.03 of its time.
float inverse_of_power_of_two(float value) { return intBitsToFloat(0x7f000000 - floatBitsToInt(value)); }

// Level m starts at row atlas_rows * (1 - 2^-m): the base at 0, each level below the one before (docs/formats.md).
vec2 load_atlas(vec2 cell, float cell_size_px) {
  float cells_per_px = inverse_of_power_of_two(cell_size_px);
  float first_row = atlas_height - atlas_height * cells_per_px;
  return textureLod(pyramid_atlas, vec2(cell.x + 0.5, cell.y + (first_row + 0.5)) * atlas_uv, 0.0).xy;
}

#include "ssr_march_hiz_tuned.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    hit = march_hiz_tuned(ray, trace_parameters());
  }
  trace_end(hit);
}
