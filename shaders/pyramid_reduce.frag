// One level of the depth pyramid from the level below: least and greatest dist_view of 2 x 2 cells.
//
// The base is padded so that every level has an even size: the four cells are the exact cover of this one.
#version 450

layout(binding = 1) uniform sampler2D finer;

layout(location = 0) out vec2 depths;

void main() {
  // Nearest samples at the centres: faster on llvmpipe than texelFetch.
  vec2 texel_uv = 1.0 / vec2(textureSize(finer, 0));
  vec2 child = (2.0 * gl_FragCoord.xy - 0.5) * texel_uv;
  vec2 a = textureLod(finer, child, 0.0).xy;
  vec2 b = textureLod(finer, child + vec2(texel_uv.x, 0.0), 0.0).xy;
  vec2 c = textureLod(finer, child + vec2(0.0, texel_uv.y), 0.0).xy;
  vec2 d = textureLod(finer, child + texel_uv, 0.0).xy;
  depths = vec2(min(min(a.x, b.x), min(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)));
}
