// Level 0 of the depth pyramid: least and greatest dist_view of each texel, padded to whole cells of the coarsest level.
//
// In: dist_view, metres, +inf for background. Out: x least, +inf for background and padding; y greatest, 0 there, so
// that neither ever makes a cell's column larger.
#version 450

layout(std140, binding = 0) uniform PyramidBlock {
  vec2 size_px;
  vec2 texel_uv;  // 1 / size_px
};

layout(binding = 1) uniform sampler2D dist_view;

layout(location = 0) out vec2 depths;

void main() {
  float dist = textureLod(dist_view, gl_FragCoord.xy * texel_uv, 0.0).x;
  bool is_column = all(lessThan(gl_FragCoord.xy, size_px)) && !isinf(dist);
  depths = is_column ? vec2(dist) : vec2(uintBitsToFloat(0x7f800000u), 0.0);
}
