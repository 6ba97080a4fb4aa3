#version 450

layout(constant_id = 4) const float kReach = 1.0;  // of the triangle: 1 covers the viewport

void main() {
  vec2 corner = vec2((SSR_VERTEX_INDEX << 1) & 2, SSR_VERTEX_INDEX & 2);
  gl_Position = vec4(kReach * (2.0 * corner - 1.0), 0.0, 1.0);
}
