// A mask of blue noise: 0..1 spread so that neighbours differ as much as they can, without a pattern to be
// seen.
#pragma once

#include <vector>

#include "base/error.h"
#include "frame/frame_images.h"

namespace ssrkit {

constexpr int kBlueNoiseSide = 64;  // as in shaders/include/random.glsl

// Each of the side * side ranks once, over their count; row by row; tiles without a seam. Void-and-cluster
// (Ulichney, "The Void-and-Cluster Method for Dither Array Generation", SPIE 1913, 1993).
[[nodiscard]] std::vector<float> blueNoise(int side, unsigned seed);

// The image `blue_noise`: two independent masks of kBlueNoiseSide, made once a process.
[[nodiscard]] Expected<void> uploadBlueNoise(Device& device, FrameImages& images);

}  // namespace ssrkit
