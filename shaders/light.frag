// Lights the G-buffer: Lambert and Blinn-Phong from directional and point lights, constant ambient, emission; the sky
// where there is no surface.
//
// In: albedo, normal_view, material, emission, dist_view. Out: lit, linear radiance, at most the largest half.
// Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977; the lobe is normalised by
// (n + 8) / 8 pi (Akenine-Moller et al., "Real-Time Rendering", 4th ed., section 9.8.1) so that shininess moves energy
// about instead of adding it. Shininess comes from roughness by n = 2 / roughness^4 - 2 (same, section 9.8.1).
#version 450
#include "punctual_lights.glsl"
#include "sky.glsl"
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"
#include "unit_normal.glsl"

const int MAX_LIGHTS = 8;
const float PI = 3.14159265358979;
const float LARGEST_HALF = 65504.0;
const float AMBIENT = 0.25;  // of the sky's horizon colour, on every side
const float MIN_ROUGHNESS = 0.15;  // a sharper highlight of an infinitely small light is one flickering pixel

// Of the scene: loops of a known length are written out, and a light's members are read at once.
layout(constant_id = 0) const int directional_count = 1;
layout(constant_id = 1) const int point_count = 0;

layout(std140, binding = 0) uniform LightBlock {
  vec2 px_offset;
  vec2 view_per_px;
  vec2 texel_uv;
  vec3 up_view;  // the world's up
  vec3 sky_horizon;
  vec3 sky_zenith;
  vec4 directional_dir_view[MAX_LIGHTS];  // the way the light travels
  vec4 directional_radiance[MAX_LIGHTS];
  vec4 point_p_view[MAX_LIGHTS];    // a: range in metres, 0 unlimited
  vec4 point_dir_view[MAX_LIGHTS];  // a: cosine of the outer cone, -1 for a point light
  vec4 point_intensity[MAX_LIGHTS]; // a: cosine of the inner cone
};

layout(binding = 1) uniform sampler2D albedo;
layout(binding = 2) uniform sampler2D normal_view;
layout(binding = 3) uniform sampler2D material;
layout(binding = 4) uniform sampler2D emission;
layout(binding = 5) uniform sampler2D dist_view;

layout(location = 0) out vec4 lit;

struct Surface {
  vec3 normal;
  vec3 to_eye;
  vec3 diffuse;   // albedo of the diffuse part
  vec3 specular;  // reflectance at normal incidence
  float shininess;
};

vec3 reflected_light(Surface surface, vec3 to_light, vec3 irradiance) {
  float cosine = max(ordered_dot(surface.normal, to_light), 0.0);
  vec3 half_vector = unit_normal(to_light + surface.to_eye, surface.to_eye);  // none when light comes from behind
  float lobe = pow(max(ordered_dot(surface.normal, half_vector), 0.0), surface.shininess);
  vec3 highlight = surface.specular * (lobe * (surface.shininess + 8.0) / (8.0 * PI));
  return (surface.diffuse / PI + highlight) * irradiance * cosine;
}

void main() {
  // Nearest samples in the place of texelFetch: the same texels in less time on llvmpipe.
  vec2 uv = gl_FragCoord.xy * texel_uv;
  float dist = textureLod(dist_view, uv, 0.0).x;
  bool is_background = isinf(dist);
  vec3 p_view = vec3((gl_FragCoord.xy - px_offset) * view_per_px, -1.0) * (is_background ? 1.0 : dist);
  vec3 from_eye = ordered_normalize(p_view);
  if (is_background) {
    lit = vec4(sky_radiance(ordered_dot(from_eye, up_view), sky_horizon, sky_zenith), 1.0);
    return;
  }
  vec3 base_colour = textureLod(albedo, uv, 0.0).rgb;
  vec4 metal_rough = textureLod(material, uv, 0.0);
  float roughness = max(metal_rough.g, MIN_ROUGHNESS);
  float alpha = roughness * roughness;
  Surface surface = Surface(unit_normal(textureLod(normal_view, uv, 0.0).xyz, -from_eye), -from_eye,
                            base_colour * (1.0 - metal_rough.r), mix(vec3(0.04), base_colour, metal_rough.r),
                            2.0 / (alpha * alpha) - 2.0);
  vec3 radiance = textureLod(emission, uv, 0.0).rgb + (AMBIENT * surface.diffuse) * sky_horizon;
  for (int i = 0; i < directional_count; ++i) {
    radiance += reflected_light(surface, -directional_dir_view[i].xyz, directional_radiance[i].rgb);
  }
  for (int i = 0; i < point_count; ++i) {
    vec3 offset_m = point_p_view[i].xyz - p_view;
    float distance_m = sqrt(ordered_dot(offset_m, offset_m));
    vec3 to_light = offset_m / max(distance_m, 1e-6);
    float falloff = punctual_falloff(distance_m, point_p_view[i].a, ordered_dot(-to_light, point_dir_view[i].xyz),
                                     point_intensity[i].a, point_dir_view[i].a);
    radiance += reflected_light(surface, to_light, point_intensity[i].rgb * falloff);
  }
  lit = vec4(min(radiance, LARGEST_HALF), 1.0);
}
