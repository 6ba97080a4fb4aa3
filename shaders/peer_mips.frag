// One mip of a peer's depth from the mip before: the nearest or the farthest surface below.
//
// In: finer, a mip of peer_depth. Out: the next one. Where a side of `finer` is odd every texel looks at three of it in
//     the place of two, so that nothing is left out, whether a texel is taken for its share of the image or for the
//     texels whose number is its own without the last bit.
#version 450

layout(std140, binding = 0) uniform PeerMipsBlock {
  float peer_mips_sign;  // 1: the least number is kept, -1: the greatest
};

layout(binding = 1) uniform sampler2D finer;

layout(location = 0) out float coarser;

void main() {
  ivec2 finer_size = textureSize(finer, 0);
  ivec2 first = 2 * ivec2(gl_FragCoord.xy);
  ivec2 end = min(first + 2 + (finer_size & 1), finer_size);
  float kept = peer_mips_sign * texelFetch(finer, first, 0).x;
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      kept = min(kept, peer_mips_sign * texelFetch(finer, ivec2(x, y), 0).x);
    }
  }
  coarser = peer_mips_sign * kept;
}
