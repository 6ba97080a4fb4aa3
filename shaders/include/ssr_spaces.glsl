// The spaces of the kit, and the only place with a flip or a depth range (docs/spaces.md; C++: spaces/camera.h).
//
//   view    +x right, +y up, the camera looks along -z; metres. dist_view = -p_view.z, positive.
//   clip    p_clip = clip_from_view * p_view, undivided; p_clip.w = dist_view.
//   NDC     +x right, +y up, z 0 at the near plane and 1 at the far plane.
//   pixel   p_px, origin upper left, +y down, texel centres at .5; texel = floor(p_px).
//
// Projection between view and pixel positions, for any perspective camera:
//   p_px = px_scale * (p_view.xy / dist_view) + px_offset
#ifndef SSR_SPACES_GLSL
#define SSR_SPACES_GLSL

struct PixelProjection {
  vec2 px_scale;     // pixels per unit of x / dist_view; y is negative because p_px grows downwards
  vec2 px_offset;    // p_px of the principal point
  vec2 view_per_px;  // 1 / px_scale, rounded once from double precision
};

vec3 position_px_to_view(vec2 p_px, float dist_view, PixelProjection projection) {
  return vec3(dist_view * ((p_px - projection.px_offset) * projection.view_per_px), -dist_view);
}

vec2 position_view_to_px(vec3 p_view, PixelProjection projection) {
  return projection.px_scale * (vec2(p_view) / -p_view.z) + projection.px_offset;
}

// The same from clip space, for cameras whose p_clip.w is dist_view.
vec2 position_clip_to_px(vec4 p_clip, vec2 size_px) {
  return (0.5 * size_px) * (vec2(p_clip.x, -p_clip.y) / p_clip.w + 1.0);
}

// The rasteriser's clip position. With GL's clip control at (lower left, zero to one) and Vulkan's positive viewport,
// row 0 of the image is NDC y = -1 on both: one flip puts the upper edge of the picture there, on every API.
vec4 rasterizer_from_clip(vec4 p_clip) { return vec4(p_clip.x, -p_clip.y, p_clip.z, p_clip.w); }

// The rasteriser stores depth_window = P23 / dist_view - P22 of the projection P, 0 at the near plane and 1 at the far
// plane on every API. An inverse of OpenGL's matrix with its -1..1 range needs 2 * depth_window - 1 instead.
float dist_view_from_depth_window(float depth_window, mat4 clip_from_view) {
  return clip_from_view[3][2] / (depth_window + clip_from_view[2][2]);
}

#endif
