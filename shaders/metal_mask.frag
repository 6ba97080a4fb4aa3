// Masks rays by metalness: a surface that is no metal at all reflects nothing, and its pixels cost no lookup.
//
// In: material. Out: material_masked, the same with b (1 where rays are traced) 0 where metallic is 0.
#version 450

layout(binding = 1) uniform sampler2D material;

layout(location = 0) out vec4 material_masked;

void main() {
  vec4 surface = texelFetch(material, ivec2(gl_FragCoord.xy), 0);
  material_masked = vec4(surface.rg, surface.r > 0.0 ? surface.b : 0.0, surface.a);
}
