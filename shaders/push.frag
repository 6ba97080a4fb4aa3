// The push of push-pull: fills each hole from the finest mips of `known` that reach it; a known pixel stays as it is.
//
// The push phase of Gortler et al. 1996 hands each mip down to the next finer one (Kraus, "The Pull-Push Algorithm
// Revisited", GRAPP 2009); here each hole reads the mips itself, finest first, which is one pass instead of one a mip.
// In:  reflection (straight alpha), known (the pulled mips), material, dist_view.
//      fill_levels: the coarsest mip that is used. Holes wider than its texels stay holes.
// Out: reflection_filled, straight alpha. A hole's grows with how much is known around it: a pixel beside what is
//      reflected, where the ray rightly found nothing, is no hole, and stays as it is.
#version 450

const float ENOUGH = 0.999;  // rounding leaves a full sum a little below 1
// The most that a mip, sampled bilinearly, says is known just outside a straight edge: e (48 - e) / 1024 of a cell of
// 32 texels that the edge cuts at e = 24.
const float BESIDE_AN_EDGE = 9.0 / 16.0;

layout(std140, binding = 0) uniform PushBlock {
  vec2 size_px;
  int fill_levels;
};

layout(binding = 1) uniform sampler2D reflection;
layout(binding = 2) uniform sampler2D known;
layout(binding = 3) uniform sampler2D material;
layout(binding = 4) uniform sampler2D dist_view;

layout(location = 0) out vec4 reflection_filled;

// Colours found so far, as differences from the first, so that a constant keeps its bits.
struct Filling {
  vec3 first;
  vec3 sum;         // of differences, weighed by alpha
  float alpha_sum;
  float weight;     // 1: nothing is left for coarser mips
};

struct Corner {
  vec4 found;
  float near;  // bilinear weight
};

// One of the four texels of a mip about this pixel.
Corner load_corner(int mip, int i) {
  ivec2 mip_size = max(ivec2(size_px) >> mip, ivec2(1));
  vec2 at = gl_FragCoord.xy / size_px * vec2(mip_size) - 0.5;
  vec2 share = at - floor(at);
  ivec2 corner = ivec2(i & 1, i >> 1);
  vec2 near = mix(1.0 - share, share, vec2(corner));
  ivec2 texel = clamp(ivec2(floor(at)) + corner, ivec2(0), mip_size - 1);
  return Corner(texelFetch(known, texel, mip), near.x * near.y);
}

// Loops that run no turn, not branches, are what software rasterisers skip: `corners` is 4, or 0 where there is no
// hole.
float known_around(int mip, int corners) {
  float sum = 0.0;
  for (int i = 0; i < corners; ++i) {
    Corner corner = load_corner(mip, i);
    sum += corner.near * corner.found.a;
  }
  return sum;
}

void fill_from(inout Filling filling, int mip) {
  float left = 1.0 - filling.weight;
  for (int i = 0; i < 4; ++i) {
    Corner corner = load_corner(mip, i);
    if (corner.found.a > 0.0) {
      float weight = left * corner.near;
      filling.first = filling.weight > 0.0 ? filling.first : corner.found.rgb;
      filling.sum += (weight * corner.found.a) * (corner.found.rgb - filling.first);
      filling.alpha_sum += weight * corner.found.a;
      filling.weight += weight;
    }
  }
}

void main() {
  vec2 uv = gl_FragCoord.xy / size_px;
  reflection_filled = textureLod(reflection, uv, 0.0);
  bool is_reflective = textureLod(material, uv, 0.0).b > 0.0 && !isinf(textureLod(dist_view, uv, 0.0).x);
  bool is_hole = is_reflective && reflection_filled.a == 0.0;
  int coarsest = min(fill_levels, textureQueryLevels(known) - 1);
  float around = known_around(coarsest, is_hole ? 4 : 0);
  float alpha = (around - BESIDE_AN_EDGE) / (1.0 - BESIDE_AN_EDGE);
  Filling filling = Filling(vec3(0.0), vec3(0.0), 0.0, 0.0);
  for (int mip = 1; mip <= (alpha > 0.0 ? coarsest : 0) && filling.weight < ENOUGH; ++mip) {
    fill_from(filling, mip);
  }
  if (filling.alpha_sum > 0.0) {
    reflection_filled = vec4(filling.first + filling.sum / filling.alpha_sum, alpha);
  }
}
