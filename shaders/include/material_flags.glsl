// What a material has, as bits of one number of its row of material_table: three reads a pixel in the place of five.
#ifndef MATERIAL_FLAGS_GLSL
#define MATERIAL_FLAGS_GLSL

const int MATERIAL_MIRROR = 1;
const int MATERIAL_BASE_COLOUR_TEXTURE = 2;
const int MATERIAL_METALLIC_ROUGHNESS_TEXTURE = 4;
const int MATERIAL_NORMAL_TEXTURE = 8;
const int MATERIAL_EMISSIVE_TEXTURE = 16;
const int MATERIAL_DOUBLE_SIDED = 32;

bool material_has(vec4 surface, int flag) { return (int(surface.z) & flag) != 0; }

#endif
