// Exact area weights of one mip in the next, for every size.
//
// A mip of an odd size 2n + 1 has n texels above it, each as wide as 2 + 1/n of its own: three of them, cut at other
// places in each. Filters of two texels drop the last row and column there and shift the image more with each mip.
// Guthe and Heckbert, "Non-Power-of-Two Mipmapping", NVIDIA 2005.
#ifndef BOX_FILTER_GLSL
#define BOX_FILTER_GLSL

// Weights of the texels first, first + 1 and first + 2 in the coarser texel, along one axis; they sum to 1.
vec3 box_weights(int coarser_texel, int finer_size) {
  if (finer_size == 1) {
    return vec3(1.0, 0.0, 0.0);
  }
  int n = finer_size / 2;
  bool is_odd = finer_size != 2 * n;
  vec3 shares = is_odd ? vec3(n - coarser_texel, n, coarser_texel + 1) : vec3(1.0, 1.0, 0.0);
  return shares / (is_odd ? float(finer_size) : 2.0);
}

#endif
