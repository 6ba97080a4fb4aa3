// How far each pixel's reflection is to be blurred, beside its depth.
//
// In:  material, dist_view, hit_texel, hit_point; max_radius_px.
// Out: blur_guide, x dist_view, y radius in pixels; -1 where nothing is reflected.
// The cone's circle at the hit is seen in the mirror, at the distance of the mirror plus the ray's: its radius in
// pixels is 0 at contact and grows with roughness and with the ray's length up to that of a miss, which comes from
// infinity. The kernel (1 - x^2)^2 must be wider than the circle to blur as much: its variance is a seventh of its
// radius squared, an even disc's a quarter.
#version 450
#include "cone.glsl"

const float KERNEL_PER_CIRCLE = 1.3228757;  // sqrt(7 / 4)

layout(std140, binding = 0) uniform GuideBlock {
  vec2 px_scale;
  vec2 px_offset;
  vec2 view_per_px;
  float max_radius_px;
};

layout(binding = 1) uniform sampler2D material;
layout(binding = 2) uniform sampler2D dist_view;
layout(binding = 3) uniform isampler2D hit_texel;
layout(binding = 4) uniform sampler2D hit_point;

layout(location = 0) out vec2 blur_guide;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float dist = texelFetch(dist_view, texel, 0).x;
  vec4 surface = texelFetch(material, texel, 0);
  if (isinf(dist) || surface.b == 0.0) {
    blur_guide = vec2(dist, -1.0);
    return;
  }
  float eye_m_per_dist = length(vec3((gl_FragCoord.xy - px_offset) * view_per_px, 1.0));
  float t_m = texelFetch(hit_point, texel, 0).z;
  float ray_share = texelFetch(hit_texel, texel, 0).x < 0 ? 1.0 : t_m / (eye_m_per_dist * dist + t_m);
  float kernel = KERNEL_PER_CIRCLE * cone_circle_per_m(cone_tangent(surface.g));
  blur_guide = vec2(dist, min(abs(px_scale.y) * kernel * ray_share * eye_m_per_dist, max_radius_px));
}
