// One level of the depth pyramid from the level below: least and greatest dist_view of 2 x 2 cells.
//
// The base is padded so that every level has an even size: the four cells are the exact cover of this one.
#version 450

layout(binding = 1) uniform sampler2D finer;

layout(location = 0) out vec2 depths;

void main() {
  ivec2 child = 2 * ivec2(gl_FragCoord.xy);
  vec2 a = texelFetch(finer, child, 0).xy;
  vec2 b = texelFetch(finer, child + ivec2(1, 0), 0).xy;
  vec2 c = texelFetch(finer, child + ivec2(0, 1), 0).xy;
  vec2 d = texelFetch(finer, child + ivec2(1, 1), 0).xy;
  depths = vec2(min(min(a.x, b.x), min(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)));
}
