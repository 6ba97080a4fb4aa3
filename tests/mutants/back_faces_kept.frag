// Mutant of confidence.frag: holds the normal of the hit against that of the receiver.
//
// In:  reflection (straight alpha), hit_texel, hit_point, ray_work, normal_view; the constants of a technique's row say
//      which factors it uses: edge_fade_fraction 0, fade_distance_m 1e30, facing_fade_start over 1 and fade_lookups
//      1e30 leave theirs at 1.
// Out: reflection_weighed, rgb as it was, a its confidence. On a miss all zero.
#version 450
#include "confidence.glsl"

layout(std140, binding = 0) uniform ConfidenceBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_offset;
  vec2 view_per_px;
  float max_distance_m;
  int lookup_budget;
  float edge_fade_fraction;  // of the image's width and height
  float fade_distance_m;
  int rejects_back_faces;
  float facing_fade_start;   // dir_view.z: 1 straight into the camera
  float facing_fade_end;
  float fade_lookups;
};

layout(binding = 1) uniform sampler2D reflection;
layout(binding = 2) uniform isampler2D hit_texel;
layout(binding = 3) uniform sampler2D hit_point;
layout(binding = 4) uniform usampler2D ray_work;
layout(binding = 5) uniform sampler2D normal_view;

layout(location = 0) out vec4 reflection_weighed;

void main() {
  // Nearest samples in the place of texelFetch: the same texels, in nine tenths of the pass's time on llvmpipe.
  vec2 uv = gl_FragCoord.xy * texel_uv;
  ivec2 hit = textureLod(hit_texel, uv, 0.0).xy;
  if (hit.x < 0) {
    reflection_weighed = vec4(0.0);
    return;
  }
  vec4 found = textureLod(reflection, uv, 0.0);
  vec3 point = textureLod(hit_point, uv, 0.0).xyz;
  vec3 from_eye = ordered_normalize(vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0));
  vec3 dir_view = ordered_reflect(from_eye, ordered_normalize(textureLod(normal_view, uv, 0.0).xyz));
  float confidence = edge_fade(point.xy, size_px, edge_fade_fraction);
  confidence *= distance_fade(point.z, min(max_distance_m, fade_distance_m));
  confidence *= facing_fade(dir_view.z, facing_fade_start, facing_fade_end);
  confidence *= budget_fade(float(textureLod(ray_work, uv, 0.0).y), min(float(lookup_budget), fade_lookups));
  if (rejects_back_faces != 0 && confidence > 0.0) {
    confidence *= back_face_weight(texelFetch(normal_view, hit, 0).xyz, -textureLod(normal_view, uv, 0.0).xyz);
  }
  reflection_weighed = vec4(found.rgb, found.a * confidence);
}
