// One triangle over the whole viewport; the fragment shader knows where it is from gl_FragCoord.
//
// Three vertices are a layer: layer 0 lies at the far end, behind every surface, and each one at half the depth of the one
// before, so that passes which test and write one depth image, layer by layer, pass where the first one did.
#version 450

void main() {
  int layer = SSR_VERTEX_INDEX / 3;
  int index = SSR_VERTEX_INDEX - 3 * layer;
  vec2 corner = vec2((index << 1) & 2, index & 2);
  gl_Position = vec4(2.0 * corner - 1.0, 1.0 / float(1 << layer), 1.0);
}
