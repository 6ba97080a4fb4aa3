// The depth pyramid of the Hi-Z stages, in two layouts: mip levels (textbook) and one atlas (tuned).
#pragma once

#include <string>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/programs.h"

namespace ssrkit {

enum class PyramidLayout {
  kNone,
  kMips,   // image "pyramid": mip m holds level m
  kAtlas,  // one image: level m starts at row atlas_rows * (1 - 2^-m)
};

// The layout that a trace shader asks for by the name of its sampler.
[[nodiscard]] PyramidLayout pyramidLayoutOf(const Program& trace);

// The image's size rounded up to whole cells of the coarsest level.
[[nodiscard]] Size paddedSize(Size size, int max_mip);

// As wide as that and twice as high.
[[nodiscard]] Size atlasSize(Size size, int max_mip);

// The image that the levels stand in. An atlas is "pyramid_atlas", or, for the frame's own depth, the image
// whose upper rows the G-buffer's rasteriser has left the base in ("dist_range"), where that is one of this
// size.
[[nodiscard]] std::string pyramidImage(PyramidLayout layout, int max_mip, const std::string& source,
                                       const FrameImages& images);

struct PyramidPrograms {
  const Program* base = nullptr;
  const Program* reduce = nullptr;
};
[[nodiscard]] const PassRow& pyramidBasePass();
[[nodiscard]] const PassRow& pyramidReducePass();

// Builds levels 0..max_mip of pyramidImage() from the image `source` ("dist_view", or what a technique has in
// its place) and sets the uniforms that trace shaders read the atlas by. The time is the sum of its passes
// and copies.
[[nodiscard]] Expected<PassTime> buildPyramid(Device& device, const PyramidPrograms& programs,
                                              PyramidLayout layout, int max_mip, const std::string& source,
                                              FrameImages& images, UniformValues& values);

}  // namespace ssrkit
