// Smooths the reflection where its own variance says that it is noise, along the surface and not across its edges.
//
// In:  reflection and reflection_variance under the names unfiltered and unfiltered_variance; dist_view, normal_view,
//      material; spacing_px between the filter's 3 x 3 taps. Out: reflection, reflection_variance after it.
// One level of an edge-avoiding a-trous filter: Dammertz et al., "Edge-Avoiding A-Trous Wavelet Transform for fast
// Global Illumination Filtering", HPG 2010; differences of luminance are measured in standard deviations as in Schied
// et al., "Spatiotemporal Variance-Guided Filtering", HPG 2017, section 4.4. Without variance nothing is smoothed:
// mirrors stay.
#version 450
#include "ray_reuse.glsl"

const float LUMINANCE_SPREAD = 4.0;   // standard deviations
const float PLANE_SPREAD = 0.01;      // distance off the tangent plane, as a fraction of dist_view
const float NORMAL_SPREAD = 0.02;     // 1 - cosine between normals
const float ROUGHNESS_SPREAD = 0.02;

layout(std140, binding = 0) uniform FilterBlock {
  vec2 size_px;
  vec2 texel_uv;
  vec2 px_offset;
  vec2 view_per_px;
  int spacing_px;
};

layout(binding = 1) uniform sampler2D unfiltered;
layout(binding = 2) uniform sampler2D unfiltered_variance;
layout(binding = 3) uniform sampler2D dist_view;
layout(binding = 4) uniform sampler2D normal_view;
layout(binding = 5) uniform sampler2D material;

layout(location = 0) out vec4 reflection;
layout(location = 1) out float reflection_variance;

struct Centre {
  vec3 p_view;
  vec3 normal;
  float dist;
  float roughness;
  float luminance;
  float variance;
};

// 0..1; background has no surface to be along. Nearest samples are faster than texelFetch on llvmpipe.
float similarity(Centre centre, vec2 tap_px, vec4 value, float variance) {
  vec2 uv = tap_px * texel_uv;
  float dist = textureLod(dist_view, uv, 0.0).x;
  vec4 surface = textureLod(material, uv, 0.0);
  if (isinf(dist) || surface.b == 0.0) {
    return 0.0;
  }
  vec3 p_view = dist * vec3((tap_px - px_offset) * view_per_px, -1.0);
  vec3 normal = textureLod(normal_view, uv, 0.0).xyz;
  float off_plane = abs(ordered_dot(p_view - centre.p_view, centre.normal)) / (PLANE_SPREAD * centre.dist);
  float bent = max(1.0 - ordered_dot(normal, centre.normal), 0.0) / NORMAL_SPREAD;
  float rougher = abs(surface.g - centre.roughness) / ROUGHNESS_SPREAD;
  float deviation = sqrt(centre.variance + variance) + 1e-6;
  float brighter = abs(ordered_dot(value.rgb, LUMINANCE) - centre.luminance) / (LUMINANCE_SPREAD * deviation);
  return exp(-(off_plane + bent + rougher + brighter));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  reflection = texelFetch(unfiltered, texel, 0);
  reflection_variance = texelFetch(unfiltered_variance, texel, 0).x;
  float dist = texelFetch(dist_view, texel, 0).x;
  vec4 surface = texelFetch(material, texel, 0);
  if (surface.b == 0.0 || isinf(dist) || is_mirror(surface.g)) {
    return;
  }
  Centre centre = Centre(dist * vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0),
                         ordered_normalize(texelFetch(normal_view, texel, 0).xyz), dist,
                         surface.g, ordered_dot(reflection.rgb, LUMINANCE), reflection_variance);
  vec4 centre_value = reflection;
  vec4 difference = vec4(0.0);  // a sum of differences keeps a constant's bits
  float weight_sum = 1.0;
  for (int i = 0; i < 9; ++i) {
    vec2 offset = vec2(i % 3 - 1, i / 3 - 1);
    vec2 tap_px = gl_FragCoord.xy + float(spacing_px) * offset;
    bool is_inside = all(greaterThan(tap_px, vec2(0.0))) && all(lessThan(tap_px, size_px));
    if (is_inside && i != 4) {
      vec4 value = textureLod(unfiltered, tap_px * texel_uv, 0.0);
      float variance = textureLod(unfiltered_variance, tap_px * texel_uv, 0.0).x;
      // The weights 4, 2, 1 of the 3 x 3 binomial, the middle's taken for 1.
      float weight = similarity(centre, tap_px, value, variance) * (i % 2 == 1 ? 0.5 : 0.25);
      difference += weight * (value - centre_value);
      reflection_variance += weight * weight * variance;
      weight_sum += weight;
    }
  }
  reflection = centre_value + difference / weight_sum;
  reflection_variance /= weight_sum * weight_sum;
}
