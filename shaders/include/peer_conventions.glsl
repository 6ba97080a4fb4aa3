// Between the kit's conventions and those of other people's shaders (docs/peers.md). The numbers are those of
// harness/frame/peer.h.
#ifndef PEER_CONVENTIONS_GLSL
#define PEER_CONVENTIONS_GLSL

const int PEER_DEPTH_DIST_VIEW = 0;
const int PEER_DEPTH_VIEW_Z = 1;
const int PEER_DEPTH_WINDOW = 2;
const int PEER_DEPTH_WINDOW_REVERSED = 3;
const int PEER_DEPTH_LINEAR01 = 4;

const int PEER_NORMAL_SIGNED = 0;
const int PEER_NORMAL_UNSIGNED = 1;
const int PEER_NORMAL_FORWARD = 2;

const int PEER_ANSWER_UV = 0;
const int PEER_ANSWER_UV_UPWARDS = 1;
const int PEER_ANSWER_TEXEL = 2;
const int PEER_ANSWER_MASK = 3;

// dist_view, metres, +inf for background, in the form that the peer reads.
float peer_depth_of(float dist_view, float near_m, float far_m, int form) {
  bool is_background = isinf(dist_view);
  float dist_m = is_background ? far_m : dist_view;
  float window_reversed = near_m * (far_m - dist_m) / (dist_m * (far_m - near_m));
  if (form == PEER_DEPTH_VIEW_Z) {
    return is_background ? -1e30 : -dist_view;
  }
  if (form == PEER_DEPTH_WINDOW) {
    return is_background ? 1.0 : 1.0 - window_reversed;
  }
  if (form == PEER_DEPTH_WINDOW_REVERSED) {
    return is_background ? 0.0 : window_reversed;
  }
  return form == PEER_DEPTH_LINEAR01 ? dist_m / far_m : dist_view;
}

vec3 peer_normal_of(vec3 normal_view, int form) {
  if (form == PEER_NORMAL_UNSIGNED) {
    return normal_view * 0.5 + 0.5;
  }
  return form == PEER_NORMAL_FORWARD ? vec3(normal_view.xy, -normal_view.z) : normal_view;
}

// A peer's position in pixels, origin upper left. A texel stands for its centre.
vec2 peer_position_px(vec2 answer, vec2 size_px, int form) {
  if (form == PEER_ANSWER_TEXEL) {
    return floor(answer) + 0.5;
  }
  vec2 uv = form == PEER_ANSWER_UV_UPWARDS ? vec2(answer.x, 1.0 - answer.y) : answer;
  return uv * size_px;
}

#endif
