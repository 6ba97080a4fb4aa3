// How much of the first directional light reaches each pixel: 1 all of it, 0 none.
//
// In: dist_view, normal_view, shadow_map (docs/techniques.md). Out: shadow, 0 to 1; 1 for background and where the
// scene has no directional light. Without a scene (a G-buffer made by others) the map is empty: nothing casts a
// shadow.
#version 450
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"

layout(std140, binding = 0) uniform ShadowBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  vec2 shadow_atlas_texel_uv;
  mat4 light_from_view;
  vec4 shadow_cascades[4];
  float shadow_side_texels;
  float shadow_near_m;
  float shadow_range_m;
  int directional_count;
};

layout(binding = 1) uniform sampler2D dist_view;
layout(binding = 2) uniform sampler2D normal_view;
layout(binding = 3) uniform sampler2D shadow_map;

layout(location = 0) out float shadow;

// Nearest samples instead of texelFetch: the same texels, and 1.7 times as fast on llvmpipe.
float load_dist_view(vec2 texel) { return textureLod(dist_view, (texel + 0.5) * texel_uv, 0.0).x; }

float load_shadow_depth(vec2 texel) { return textureLod(shadow_map, (texel + 0.5) * shadow_atlas_texel_uv, 0.0).x; }

#include "geometric_normal.glsl"
#include "shadow_map.glsl"

void main() {
  vec2 texel = floor(gl_FragCoord.xy);
  float dist = load_dist_view(texel);
  // Without a branch: it would spare nothing on software rasterisers, and cost its mask.
  bool is_unshadowed = isinf(dist) || directional_count == 0;
  dist = is_unshadowed ? 1.0 : dist;
  PixelProjection projection = PixelProjection(px_scale, px_offset, view_per_px);
  vec3 p_view = position_px_to_view(texel + 0.5, dist, projection);
  vec3 shading_normal = ordered_normalize(texelFetch(normal_view, ivec2(texel), 0).xyz);
  vec3 normal = geometric_normal(p_view, shading_normal, texel, projection, size_px);
  ShadowMap map = ShadowMap(shadow_cascades[0], shadow_cascades[1], shadow_cascades[2], shadow_cascades[3],
                            shadow_side_texels, shadow_near_m, shadow_range_m);
  vec3 p_light = ordered_transform(light_from_view, vec4(p_view, 1.0)).xyz;
  vec3 normal_light = ordered_transform(light_from_view, vec4(normal, 0.0)).xyz;
  float shading_cosine = -ordered_transform(light_from_view, vec4(shading_normal, 0.0)).z;
  // A sphere's facets just past its terminator face away and are still lit by their smooth normal. Their own plane
  // would cut the terminator into teeth: they are compared as points, with the bias of the smooth normal.
  bool faces_away = -normal_light.z <= SHADOW_MIN_COSINE;
  vec2 slope = faces_away ? vec2(0.0) : shadow_slope(normal_light);
  float visibility = shadow_visibility(p_light, slope, faces_away ? shading_cosine : -normal_light.z, map);
  shadow = is_unshadowed ? 1.0 : shading_cosine > 0.0 ? visibility : 0.0;
}
