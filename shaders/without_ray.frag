// The class of every texel from which no ray starts; drawn before each tracer.
//
// In:  material (b: 1 where rays are traced; a: 0 for background). One read a texel: with a second one, of dist_view, the
//      pass takes half as long again.
// Out: ray_work (class, 0, 0) and the depth, the near end. A texel with a ray stays at the far end, where the tracer's
//      triangle passes the depth test; elsewhere the tracer is not run, and the other images of the record keep their
//      clear: -1, no hit.
// A software rasteriser runs the branches that no pixel of a block takes, but not blocks that fail the early depth test:
// a tracer costs nothing where there is nothing to trace (docs/performance.md).
#version 450
#include "ssr_contract.glsl"

layout(std140, binding = 0) uniform WithoutRayBlock {
  vec2 texel_uv;
  int ray_stride_texels;
};

layout(binding = 1) uniform sampler2D material;

layout(location = 0) out uvec4 ray_work;

void main() {
  vec2 texel = floor(gl_FragCoord.xy) * float(ray_stride_texels);
  vec2 uv = (texel + 0.5) * texel_uv;
  vec4 surface = textureLod(material, uv, 0.0);
  bool is_background = surface.a == 0.0;
  bool has_ray = !is_background && surface.b != 0.0;
  ray_work = uvec4(is_background ? RAY_BACKGROUND : RAY_MASKED, 0, 0, 0);
  gl_FragDepth = has_ray ? 1.0 : 0.0;
}
