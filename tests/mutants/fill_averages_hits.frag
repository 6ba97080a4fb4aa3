// Mutant of push.frag: averages where the rays around a hole hit, and fetches the colour there.
#version 450

layout(binding = 1) uniform sampler2D reflection;
layout(binding = 2) uniform isampler2D hit_texel;
layout(binding = 3) uniform sampler2D lit;

layout(location = 0) out vec4 reflection_filled;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  reflection_filled = texelFetch(reflection, texel, 0);
  if (reflection_filled.a > 0.0) {
    return;
  }
  vec3 sum = vec3(0.0);
  ivec2 last = textureSize(hit_texel, 0) - 1;
  for (int y = -6; y <= 6; y += 2) {
    for (int x = -6; x <= 6; x += 2) {
      ivec2 hit = texelFetch(hit_texel, clamp(texel + ivec2(x, y), ivec2(0), last), 0).xy;
      sum += hit.x >= 0 ? vec3(hit, 1.0) : vec3(0.0);
    }
  }
  if (sum.z > 0.0) {
    reflection_filled = vec4(texelFetch(lit, ivec2(sum.xy / sum.z), 0).rgb, 1.0);
  }
}
