// Takes alpha out of a colour that it is multiplied into.
//
// In: reflection, premultiplied. Out: unpremultiplied, rgb 0 where a is 0.
#version 450

layout(binding = 1) uniform sampler2D reflection;

layout(location = 0) out vec4 unpremultiplied;

void main() {
  vec4 value = texelFetch(reflection, ivec2(gl_FragCoord.xy), 0);
  unpremultiplied = value.a > 0.0 ? vec4(value.rgb / value.a, value.a) : vec4(0.0);
}
