#version 450

void main() {
  vec2 corner = vec2((SSR_VERTEX_INDEX << 1) & 2, SSR_VERTEX_INDEX & 2);
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
