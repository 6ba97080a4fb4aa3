// Puts the reflections of several frames together.
//
// A reflection does not move with the mirror that shows it, but with the image behind the mirror: the hit point,
// mirrored at the receiver's plane. Where that image was in the previous frame follows from where the hit point and the
// mirror were; both are found by their own motions. (The same idea as reprojecting by the hit's distance: Stachowiak,
// "Stochastic Screen-Space Reflections", SIGGRAPH 2015 course; here with the plane itself, so that it is exact for
// plane mirrors.) The history is clamped to the 3 x 3 neighbourhood of this frame's reflection, which ends ghosts
// within a frame: Karis, "High Quality Temporal Supersampling", SIGGRAPH 2014 course.
// In:  reflection, hit_texel, hit_point, motion, dist_view, normal_view, material, previous_accumulated,
//      previous_history_length, previous_dist_view.
// Out: accumulated (like the reflection; this frame's where there is no history), history_length in frames, 0 where
//      nothing is reflected.
#version 450
#include "ssr_motion.glsl"

layout(std140, binding = 0) uniform AccumulateBlock {
  mat4 previous_view_from_view;
  vec2 size_px;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  vec2 texel_uv;  // 1 / size_px
  float near_m;
  float disocclusion_rel;
  int is_straight_alpha;     // 0: the reflection's rgb is weighed already
  float max_history_length;  // frames; this one weighs 1 / (frames + 1)
};

layout(binding = 1) uniform sampler2D reflection;
layout(binding = 2) uniform isampler2D hit_texel;
layout(binding = 3) uniform sampler2D hit_point;
layout(binding = 4) uniform sampler2D motion;
layout(binding = 5) uniform sampler2D dist_view;
layout(binding = 6) uniform sampler2D normal_view;
layout(binding = 7) uniform sampler2D material;
layout(binding = 8) uniform sampler2D previous_accumulated;
layout(binding = 9) uniform sampler2D previous_history_length;
layout(binding = 10) uniform sampler2D previous_dist_view;

layout(location = 0) out vec4 accumulated;
layout(location = 1) out float history_length;

const float SKY_DISTANCES = 1e4;  // a miss shows what is this many times as far away as the mirror

// A nearest sample instead of texelFetch: the same texel, and faster on llvmpipe. Beyond the image its edge's texels.
vec2 uv_of(ivec2 texel) { return (vec2(texel) + 0.5) * texel_uv; }

float load_previous_dist_view(ivec2 texel) { return textureLod(previous_dist_view, uv_of(texel), 0.0).x; }

#include "history_taps.glsl"

float weight_of(vec4 colour) { return is_straight_alpha != 0 ? colour.a : 1.0; }

// Premultiplied, so that what was hit and what was not can be averaged.
vec4 premultiplied(vec4 colour) { return vec4(colour.rgb * weight_of(colour), colour.a); }
vec4 straight(vec4 colour) {
  float weight = weight_of(colour);
  return weight > 0.0 ? vec4(colour.rgb / weight, colour.a) : vec4(0.0);
}

vec4 previous_reflection(ivec2 texel) { return premultiplied(textureLod(previous_accumulated, uv_of(texel), 0.0)); }
vec4 previous_length(ivec2 texel) { return textureLod(previous_history_length, uv_of(texel), 0.0); }

// The motion of what the mirror shows at this pixel.
vec2 image_motion_px(ivec2 texel, vec3 p_mirror, vec3 p_mirror_previous, vec3 normal, PreviousFrame frame,
                     PixelProjection projection) {
  ivec2 hit = textureLod(hit_texel, uv_of(texel), 0.0).xy;
  float t_m = hit.x >= 0 ? textureLod(hit_point, uv_of(texel), 0.0).z : SKY_DISTANCES * -p_mirror.z;
  precise vec3 p_hit = p_mirror + t_m * ordered_reflect(ordered_normalize(p_mirror), normal);
  vec2 own_px = vec2(0.0);
  if (hit.x >= 0) {
    vec3 p_surface = position_px_to_view(vec2(hit) + 0.5, textureLod(dist_view, uv_of(hit), 0.0).x, projection);
    own_px = own_motion_px(p_surface, textureLod(motion, uv_of(hit), 0.0).xy, frame);
  }
  vec3 p_hit_previous = moved_previous_view(p_hit, own_px, frame);
  vec3 normal_previous = mat3(frame.previous_view_from_view) * normal;
  return motion_px(mirror_image(p_hit, p_mirror, normal),
                   mirror_image(p_hit_previous, p_mirror_previous, normal_previous), frame.px_scale, frame.near_m);
}

// Least and greatest of the neighbourhood in every channel.
vec4 clamp_to_neighbours(vec4 history, ivec2 texel) {
  vec4 least = premultiplied(textureLod(reflection, uv_of(texel), 0.0));
  vec4 greatest = least;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      vec4 colour = premultiplied(textureLod(reflection, uv_of(texel + ivec2(x, y)), 0.0));
      least = min(least, colour);
      greatest = max(greatest, colour);
    }
  }
  return clamp(history, least, greatest);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float dist = textureLod(dist_view, uv_of(texel), 0.0).x;
  accumulated = textureLod(reflection, uv_of(texel), 0.0);
  history_length = 0.0;
  if (isinf(dist) || textureLod(material, uv_of(texel), 0.0).b <= 0.0) {
    return;
  }
  PreviousFrame frame = PreviousFrame(previous_view_from_view, px_scale, near_m);
  PixelProjection projection = PixelProjection(px_scale, px_offset, view_per_px);
  vec3 p_mirror = position_px_to_view(gl_FragCoord.xy, dist, projection);
  vec3 normal = ordered_normalize(textureLod(normal_view, uv_of(texel), 0.0).xyz);
  vec2 own_px = own_motion_px(p_mirror, textureLod(motion, uv_of(texel), 0.0).xy, frame);
  vec3 p_mirror_previous = moved_previous_view(p_mirror, own_px, frame);
  vec2 p_previous_px =
      gl_FragCoord.xy - image_motion_px(texel, p_mirror, p_mirror_previous, normal, frame, projection);
  PredictedSurface surface = PredictedSurface(p_mirror_previous, mat3(previous_view_from_view) * normal);
  HistoryTaps taps = history_taps(p_previous_px, surface, disocclusion_rel, size_px, projection);
  ivec2 upper_left = tap_texel(taps, 0, 0, size_px);
  ivec2 upper_right = tap_texel(taps, 1, 0, size_px);
  ivec2 lower_left = tap_texel(taps, 0, 1, size_px);
  ivec2 lower_right = tap_texel(taps, 1, 1, size_px);
  float frames = weighed_sum(taps, previous_length(upper_left), previous_length(upper_right),
                             previous_length(lower_left), previous_length(lower_right)).x;
  frames = min(frames, max_history_length);
  history_length = frames + 1.0;
  if (frames <= 0.0) {
    return;
  }
  vec4 history = weighed_sum(taps, previous_reflection(upper_left), previous_reflection(upper_right),
                             previous_reflection(lower_left), previous_reflection(lower_right));
  history = clamp_to_neighbours(history, texel);
  vec4 now = premultiplied(accumulated);
  accumulated = straight(history + (now - history) / (frames + 1.0));
}
