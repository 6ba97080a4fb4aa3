// What each pixel's ray met, in a form that its neighbours can use.
//
// In:  hit_texel, hit_point (t_m), lit; dist_view, normal_view, microfacet_normal, material.
// Out: ray_end      xyz where the ray ended, view space, metres; a its length, metres. Without a hit xyz its direction,
//                   a 0; nothing reflective: a -1, and the others 0
//      ray_radiance rgb what arrives along it: the lit texel hit, else the sky; a Fresnel's cosine, of eye and
//                   microfacet
//      ray_density  x density that it was drawn with, per steradian, 0 for a mirror's ray; y share of it that gets out,
//                   G2 / G1
// A surface too rough to be traced looks like one whose ray met nothing: the sky stands in.
#version 450
#include "ray_reuse.glsl"
#include "sky.glsl"

layout(std140, binding = 0) uniform RayEndsBlock {
  vec2 px_offset;
  vec2 view_per_px;
  vec3 up_view;
  vec3 sky_horizon;
  vec3 sky_zenith;
  float origin_bias;
};

layout(binding = 1) uniform isampler2D hit_texel;
layout(binding = 2) uniform sampler2D hit_point;
layout(binding = 3) uniform sampler2D lit;
layout(binding = 4) uniform sampler2D dist_view;
layout(binding = 5) uniform sampler2D normal_view;
layout(binding = 6) uniform sampler2D microfacet_normal;
layout(binding = 7) uniform sampler2D material;

layout(location = 0) out vec4 ray_end;
layout(location = 1) out vec4 ray_radiance;
layout(location = 2) out vec2 ray_density;

// A highlight that one ray in a hundred finds would be a spark in its nine pixels and, filtered, a blob. Brighter rays
// are dimmed to this luminance; white is 1.
const float MAX_RAY_LUMINANCE = 2.0;

vec3 without_sparks(vec3 radiance) {
  return radiance * (MAX_RAY_LUMINANCE / max(ordered_dot(radiance, LUMINANCE), MAX_RAY_LUMINANCE));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float dist = texelFetch(dist_view, texel, 0).x;
  vec4 surface = texelFetch(material, texel, 0);
  ray_end = vec4(0.0, 0.0, 0.0, -1.0);
  ray_radiance = vec4(0.0);
  ray_density = vec2(0.0);
  if (surface.b == 0.0 || isinf(dist)) {
    return;
  }
  vec3 from_pinhole = vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0);
  vec3 from_eye = ordered_normalize(from_pinhole);
  vec3 normal = ordered_normalize(texelFetch(normal_view, texel, 0).xyz);
  vec3 microfacet = ordered_normalize(texelFetch(microfacet_normal, texel, 0).xyz);
  vec3 direction = ordered_reflect(from_eye, microfacet);
  ivec2 hit = texelFetch(hit_texel, texel, 0).xy;
  vec3 origin = dist * (from_pinhole + origin_bias * microfacet);
  float t_m = texelFetch(hit_point, texel, 0).z;
  bool is_hit = hit.x >= 0;
  vec3 sky = sky_radiance(ordered_dot(direction, up_view), sky_horizon, sky_zenith);
  ray_end = is_hit ? vec4(origin + t_m * direction, max(t_m, 1e-6)) : vec4(direction, 0.0);
  vec3 arriving = is_hit ? texelFetch(lit, hit, 0).rgb : sky;
  bool is_alone = is_mirror(surface.g);  // a mirror's ray is no sample, and nobody else uses it
  float cosine = clamp(-ordered_dot(from_eye, microfacet), 0.0, 1.0);
  ray_radiance = vec4(is_alone ? arriving : without_sparks(arriving), cosine);
  mat3 frame = frame_about(normal);
  vec3 to_eye = to_frame(frame, -from_eye);
  vec3 to_light = to_frame(frame, direction);
  if (is_alone || to_eye.z <= 0.0) {
    ray_density = vec2(0.0, 1.0);
    return;
  }
  float alpha = ggx_alpha(surface.g);
  ray_density.x = reflected_density(to_eye, to_frame(frame, microfacet), alpha);
  ray_density.y = to_light.z > 0.0 ? unshadowed_share(to_eye, to_light, alpha) : 0.0;
}
