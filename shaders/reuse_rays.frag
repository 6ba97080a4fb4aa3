// Reflected radiance of each pixel from its own ray and those of its eight neighbours (ray_reuse.glsl).
//
// In:  ray_end, ray_radiance, ray_density (ray_ends.frag); dist_view, normal_view, albedo, material.
// Out: reflection, rgb radiance towards the eye, a share of the weight on rays that hit; reflection_variance, x
//      variance of the luminance of rgb as the spread of the rays tells it, 0 for mirrors.
// With hits_only rgb is the radiance hit that arrives, multiplied by a: neither Fresnel nor the sky nor the lobe's size
// is in it, for a composite that has these itself.
// The ratio of sums has the lobe's shape; its size, the share of a white environment that the lobe reflects, is the
// mean of the rays' G2 / G1, which hardly differs among neighbours.
#version 450
#include "ray_reuse.glsl"

layout(std140, binding = 0) uniform ReuseBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_offset;
  vec2 view_per_px;
  int hits_only;
};

layout(binding = 1) uniform sampler2D ray_end;
layout(binding = 2) uniform sampler2D ray_radiance;
layout(binding = 3) uniform sampler2D ray_density;
layout(binding = 4) uniform sampler2D dist_view;
layout(binding = 5) uniform sampler2D normal_view;
layout(binding = 6) uniform sampler2D albedo;
layout(binding = 7) uniform sampler2D material;

layout(location = 0) out vec4 reflection;
layout(location = 1) out float reflection_variance;


struct Receiver {
  vec3 p_view;
  mat3 frame;
  vec3 to_eye;  // in the frame
  float alpha;
  vec3 f0;
};

struct Sums {
  vec4 radiance;     // weighed rgb and hits
  float weight;
  float weight_2;
  float luminance;   // weighed
  float luminance_2;
  float share;
  float share_2;
  float count;
};

// Adds a neighbour's ray, unless it has none to give: no reflective surface, or a mirror's. Nearest samples are faster
// than texelFetch on llvmpipe.
void add_ray(Receiver receiver, vec2 uv, inout Sums sums) {
  vec4 end = textureLod(ray_end, uv, 0.0);
  vec2 density = textureLod(ray_density, uv, 0.0).xy;
  if (end.a < 0.0 || density.x <= 0.0) {
    return;
  }
  bool is_hit = end.a > 0.0;
  vec3 to_end = is_hit ? end.xyz - receiver.p_view : end.xyz;
  float length_m = max(sqrt(ordered_dot(to_end, to_end)), 1e-6);
  vec3 direction = to_end / length_m;
  vec3 to_light = to_frame(receiver.frame, direction);
  float weight = lobe_times_cosine(receiver.to_eye, to_light, receiver.alpha) / density.x;
  // Farther from the end than the neighbour, this pixel would have drawn that direction more densely: by the square of
  // the lengths. Nothing counts more for being nearer: a ray of a millimetre, into the surface beside it, says nothing.
  float nearness = is_hit ? min(end.a / length_m, 1.0) : 1.0;
  weight *= nearness * nearness;
  float cosine = sqrt(clamp(0.5 + 0.5 * ordered_dot(receiver.to_eye, to_light), 0.0, 1.0));
  vec3 reflectance = hits_only == 1 ? vec3(is_hit) : fresnel_schlick(receiver.f0, cosine);
  vec3 radiance = reflectance * textureLod(ray_radiance, uv, 0.0).rgb;
  float luminance = ordered_dot(radiance, LUMINANCE);
  sums.radiance += weight * vec4(radiance, is_hit);
  sums.weight += weight;
  sums.weight_2 += weight * weight;
  sums.luminance += weight * luminance;
  sums.luminance_2 += weight * luminance * luminance;
  float share = hits_only == 1 ? 1.0 : density.y;
  sums.share += share;
  sums.share_2 += share * share;
  sums.count += 1.0;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 own_end = texelFetch(ray_end, texel, 0);
  reflection = vec4(0.0);
  reflection_variance = 0.0;
  if (own_end.a < 0.0) {
    return;
  }
  vec4 surface = texelFetch(material, texel, 0);
  vec3 f0 = fresnel_f0(texelFetch(albedo, texel, 0).rgb, surface.r);
  if (texelFetch(ray_density, texel, 0).x == 0.0) {
    vec4 own = texelFetch(ray_radiance, texel, 0);
    float is_hit = float(own_end.a > 0.0);
    reflection = vec4((hits_only == 1 ? vec3(is_hit) : fresnel_schlick(f0, own.a)) * own.rgb, is_hit);
    return;
  }
  vec3 from_pinhole = vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0);
  mat3 frame = frame_about(ordered_normalize(texelFetch(normal_view, texel, 0).xyz));
  Receiver receiver = Receiver(texelFetch(dist_view, texel, 0).x * from_pinhole, frame,
                               to_frame(frame, -ordered_normalize(from_pinhole)), ggx_alpha(surface.g), f0);
  Sums sums = Sums(vec4(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  for (int i = 0; i < 9; ++i) {
    vec2 neighbour_px = gl_FragCoord.xy + vec2(i % 3 - 1, i / 3 - 1);
    if (all(greaterThan(neighbour_px, vec2(0.0))) && all(lessThan(neighbour_px, size_px))) {
      add_ray(receiver, neighbour_px * texel_uv, sums);
    }
  }
  if (sums.weight > 0.0) {
    float share = sums.share / sums.count;
    float mean = sums.luminance / sums.weight;
    float spread = max(sums.luminance_2 / sums.weight - mean * mean, 0.0);
    reflection = vec4(share * sums.radiance.rgb, sums.radiance.a) / sums.weight;
    // Of a product of two means: of the rays' luminance, and of the share that gets out.
    float share_spread = max(sums.share_2 / sums.count - share * share, 0.0);
    reflection_variance = share * share * spread * sums.weight_2 / (sums.weight * sums.weight) +
                          mean * mean * share_spread / sums.count;
  }
}
