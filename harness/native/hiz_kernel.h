// What the vectorised march reads and writes. Plain data: each kernel is compiled for another instruction
// set, and must share no code with the rest of the program.
#pragma once

namespace ssrkit {

// The shaders' uniforms and images, at the shaders' precision; infinite lengths are 1e30.
struct HizScene {
  int width = 0;
  int height = 0;
  float px_scale[2] = {};
  float px_offset[2] = {};
  float view_per_px[2] = {};
  float near_m = 0.0F;
  float thickness_m = 0.0F;
  float thickness_rel = 0.0F;
  float max_distance_m = 0.0F;
  float origin_bias = 0.0F;
  int lookup_budget = 0;
  float coarsest_px = 1.0F;            // side of the coarsest cell
  const float* dist_view = nullptr;    // one a texel
  const float* normal_view = nullptr;  // normal_channels a texel
  int normal_channels = 3;
  const float* pyramid =
      nullptr;  // least and greatest dist_view of each cell, in rows of pyramid_width cells
  int pyramid_width = 0;
  float pyramid_rows = 0.0F;  // level m starts at row pyramid_rows * (1 - 2^-m)
};

struct HizAnswer {
  int texel_x;
  int texel_y;
  float px_x;
  float px_y;
  float t_m;
  int ray_class;  // the contract's code
  int lookups;
};

struct HizKernel {
  const char* instruction_set;
  int lane_count;  // rays marched at once
  // The rays of `count` texels (y * width + x), none of them background, in any order.
  void (*trace)(const HizScene& scene, const int* texels, int count, HizAnswer* answers);
};

extern const HizKernel kHizBaseline;
#if defined(__x86_64__)
extern const HizKernel kHizAvx2;
extern const HizKernel kHizAvx512;
#endif

}  // namespace ssrkit
