// The push of push-pull: fills each hole from the finest mips of `known` that reach it; a known pixel stays as it is.
//
// The push phase of Gortler et al. 1996 hands each mip down to the next finer one (Kraus, "The Pull-Push Algorithm
// Revisited", GRAPP 2009); here each hole reads the mips itself, finest first, which is one pass instead of one a mip.
// In:  reflection (straight alpha), known (the pulled mips), material, dist_view.
//      fill_levels: the coarsest mip that is used. Holes wider than its texels stay holes.
// Out: reflection_filled, straight alpha. A hole's is that of what it is filled from, less the coarser that mip is.
#version 450

const float ENOUGH = 0.999;  // rounding leaves a full sum a little below 1

layout(std140, binding = 0) uniform PushBlock {
  vec2 size_px;
  int fill_levels;
};

layout(binding = 1) uniform sampler2D reflection;
layout(binding = 2) uniform sampler2D known;
layout(binding = 3) uniform sampler2D material;
layout(binding = 4) uniform sampler2D dist_view;

layout(location = 0) out vec4 reflection_filled;

// What is known so far: colours as differences from the first that was found, so that a constant keeps its bits.
struct Filling {
  vec3 first;
  vec3 sum;         // of differences, weighed by alpha
  float alpha_sum;
  float weight;     // 1: nothing is left for coarser mips
  float alpha;
};

// Adds what the four texels of a mip about this pixel know, as bilinear as all of them know it.
void fill_from(inout Filling filling, int mip, float trust) {
  ivec2 mip_size = max(ivec2(size_px) >> mip, ivec2(1));
  vec2 at = gl_FragCoord.xy / size_px * vec2(mip_size) - 0.5;
  vec2 share = at - floor(at);
  float left = 1.0 - filling.weight;
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec4 found = texelFetch(known, clamp(ivec2(floor(at)) + corner, ivec2(0), mip_size - 1), mip);
    vec2 near = mix(1.0 - share, share, vec2(corner));
    if (found.a > 0.0) {
      float weight = left * near.x * near.y;
      filling.first = filling.weight > 0.0 ? filling.first : found.rgb;
      filling.sum += (weight * found.a) * (found.rgb - filling.first);
      filling.alpha_sum += weight * found.a;
      filling.weight += weight;
      filling.alpha += weight * found.a * trust;
    }
  }
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  reflection_filled = texelFetch(reflection, texel, 0);
  bool is_reflective = texelFetch(material, texel, 0).b > 0.0 && !isinf(texelFetch(dist_view, texel, 0).x);
  if (reflection_filled.a > 0.0 || !is_reflective) {
    return;
  }
  Filling filling = Filling(vec3(0.0), vec3(0.0), 0.0, 0.0, 0.0);
  int coarsest = min(fill_levels, textureQueryLevels(known) - 1);
  for (int mip = 1; mip <= coarsest && filling.weight < ENOUGH; ++mip) {
    fill_from(filling, mip, 1.0 - float(mip) / float(fill_levels + 1));
  }
  if (filling.alpha_sum > 0.0) {
    reflection_filled = vec4(filling.first + filling.sum / filling.alpha_sum, filling.alpha);
  }
}
