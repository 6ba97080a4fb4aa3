// Mutant of resolve_history.frag: reprojects the hit by the motion of the mirror's surface: reflections slide over
// their mirrors.
//
// In and out: as resolve_history.frag.
#version 450
#include "ssr_motion.glsl"

layout(std140, binding = 0) uniform HistoryBlock {
  mat4 previous_view_from_view;
  vec2 size_px;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  float near_m;
  float disocclusion_rel;  // of the distance, off the plane where the hit point must have been
};

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D motion;
layout(binding = 3) uniform sampler2D dist_view;
layout(binding = 4) uniform sampler2D normal_view;
layout(binding = 5) uniform sampler2D previous_lit;
layout(binding = 6) uniform sampler2D previous_dist_view;

layout(location = 0) out vec4 reflection;

float load_previous_dist_view(ivec2 texel) { return texelFetch(previous_dist_view, texel, 0).x; }

#include "history_taps.glsl"

void main() {
  ivec2 hit = texelFetch(hit_texel, ivec2(gl_FragCoord.xy), 0).xy;
  if (hit.x < 0) {
    reflection = vec4(0.0);
    return;
  }
  PreviousFrame frame = PreviousFrame(previous_view_from_view, px_scale, near_m);
  PixelProjection projection = PixelProjection(px_scale, px_offset, view_per_px);
  vec2 hit_px = vec2(hit) + 0.5;
  vec2 hit_motion_px = texelFetch(motion, ivec2(gl_FragCoord.xy), 0).xy;
  vec3 p_hit = position_px_to_view(hit_px, texelFetch(dist_view, hit, 0).x, projection);
  PredictedSurface surface =
      PredictedSurface(moved_previous_view(p_hit, own_motion_px(p_hit, hit_motion_px, frame), frame),
                       mat3(previous_view_from_view) * texelFetch(normal_view, hit, 0).xyz);
  HistoryTaps taps = history_taps(hit_px - hit_motion_px, surface, disocclusion_rel, size_px, projection);
  if (!has_history(taps)) {
    reflection = vec4(0.0);
    return;
  }
  vec4 radiance = weighed_sum(taps, texelFetch(previous_lit, tap_texel(taps, 0, 0, size_px), 0),
                              texelFetch(previous_lit, tap_texel(taps, 1, 0, size_px), 0),
                              texelFetch(previous_lit, tap_texel(taps, 0, 1, size_px), 0),
                              texelFetch(previous_lit, tap_texel(taps, 1, 1, size_px), 0));
  reflection = vec4(radiance.rgb, 1.0);
}
