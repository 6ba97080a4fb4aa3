#include "frame/pyramid.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/size.h"
#include "device/pass_clock.h"

namespace ssrkit {

namespace {

constexpr PassTime kNoTime{.wall_ns = 0, .cpu_ns = 0, .device_ns = 0};

Size levelSize(Size padded, int level) {
  return {padded.width >> level, padded.height >> level};
}

// The image that holds the base in its corner; null when the G-buffer's rasteriser has left none of this
// depth.
const DeviceImage* rasterisedBase(const std::string& source, const FrameImages& images) {
  return source == "dist_view" ? images.find("dist_range") : nullptr;
}

Expected<PassTime> drawBase(Device& device, const Program& program, DeviceImage& base, const Rect& texels,
                            const std::string& source, const FrameImages& images,
                            const UniformValues& values) {
  if (texels.width == 0 || texels.height == 0) {
    return kNoTime;
  }
  return drawFullScreen(device, program,
                        {.row = &pyramidBasePass(),
                         .targets = {{&base, 0, std::nullopt}},
                         .viewport = texels,
                         .aliases = {{"dist_view", images.sampled(source)}}},
                        images, values);
}

Expected<PassTime> copyTimed(Device& device, const DeviceImage& from, int mip, Size size, DeviceImage& to,
                             int first_row) {
  const PassClock clock;
  if (const auto copied = device.copy(from, mip, size, to, 0, first_row); !copied) {
    return tl::make_unexpected(copied.error());
  }
  PassTime time = clock.elapsed();
  time.device_ns = 0;  // nobody's timestamps tell it
  return time;
}

// Level 0. What the G-buffer's rasteriser has left is taken, from where it stands or in its place; then only
// the padding is drawn.
Expected<PassTime> makeBase(Device& device, const Program& program, DeviceImage& base, Size padded,
                            const std::string& source, const FrameImages& images,
                            const UniformValues& values) {
  const DeviceImage* const rasterised = rasterisedBase(source, images);
  if (rasterised == nullptr) {
    return drawBase(device, program, base, {0, 0, padded.width, padded.height}, source, images, values);
  }
  auto sum = rasterised == &base ? Expected<PassTime>(kNoTime)
                                 : copyTimed(device, *rasterised, 0, images.size(), base, 0);
  const auto [width, height] = images.size();
  for (const Rect& padding : {Rect{width, 0, padded.width - width, height},
                              Rect{0, height, padded.width, padded.height - height}}) {
    const auto time = drawBase(device, program, base, padding, source, images, values);
    if (!sum || !time) {
      return sum ? time : sum;
    }
    *sum += *time;
  }
  return sum;
}

// Levels 1 to max_mip, each from the one below. In the atlas layout they are drawn into an image of their own
// and copied: an image may not be drawn to and sampled at once.
Expected<PassTime> makeLevels(Device& device, const Program& program, DeviceImage& base, Size padded,
                              bool is_atlas, int max_mip, FrameImages& images, const UniformValues& values) {
  PassTime sum = kNoTime;
  if (max_mip == 0) {
    return sum;
  }
  const auto upper = is_atlas ? images.getSized({.name = "pyramid_upper",
                                                 .format = Format::kRg32f,
                                                 .size = levelSize(padded, 1),
                                                 .mip_count = max_mip})
                              : Expected<DeviceImage*>(&base);
  if (!upper) {
    return tl::make_unexpected(upper.error());
  }
  for (int level = 1; level <= max_mip; ++level) {
    const int target_mip = is_atlas ? level - 1 : level;
    const SampledImage finer{.image = level == 1 ? &base : *upper,
                             .base_mip = level == 1 ? 0 : target_mip - 1};
    const Size size = levelSize(padded, level);
    auto time = drawFullScreen(device, program,
                               {.row = &pyramidReducePass(),
                                .targets = {{*upper, target_mip, std::nullopt}},
                                .viewport = {0, 0, size.width, size.height},
                                .aliases = {{"finer", finer}}},
                               images, values);
    if (time && is_atlas) {
      sum += *time;
      time = copyTimed(device, **upper, target_mip, size, base,
                       2 * padded.height - (2 * padded.height >> level));
    }
    if (!time) {
      return time;
    }
    sum += *time;
  }
  return sum;
}

}  // namespace

PyramidLayout pyramidLayoutOf(const Program& trace) {
  for (const SamplerBinding& sampler : trace.samplers) {
    if (sampler.name == "pyramid_atlas") {
      return PyramidLayout::kAtlas;
    }
    if (sampler.name == "pyramid") {
      return PyramidLayout::kMips;
    }
  }
  return PyramidLayout::kNone;
}

Size paddedSize(Size size, int max_mip) {
  const int cell = 1 << max_mip;
  return {(size.width + cell - 1) / cell * cell, (size.height + cell - 1) / cell * cell};
}

Size atlasSize(Size size, int max_mip) {
  const Size padded = paddedSize(size, max_mip);
  return {padded.width, 2 * padded.height};
}

std::string pyramidImage(PyramidLayout layout, int max_mip, const std::string& source,
                         const FrameImages& images) {
  if (layout != PyramidLayout::kAtlas) {
    return "pyramid";
  }
  const DeviceImage* const rasterised = rasterisedBase(source, images);
  const bool is_atlas = rasterised != nullptr && rasterised->desc().size == atlasSize(images.size(), max_mip);
  return is_atlas ? "dist_range" : "pyramid_atlas";
}

const PassRow& pyramidBasePass() {
  static const PassRow row{.name = "pyramid_base",
                           .vertex_shader = "full_screen.vert",
                           .fragment_shader = "pyramid_base.frag",
                           .colour_formats = {Format::kRg32f},
                           .vertex_attributes = {},
                           .vertex_stride_bytes = 0};
  return row;
}

const PassRow& pyramidReducePass() {
  static const PassRow row{.name = "pyramid_reduce",
                           .vertex_shader = "full_screen.vert",
                           .fragment_shader = "pyramid_reduce.frag",
                           .colour_formats = {Format::kRg32f},
                           .vertex_attributes = {},
                           .vertex_stride_bytes = 0};
  return row;
}

Expected<PassTime> buildPyramid(Device& device, const PyramidPrograms& programs, PyramidLayout layout,
                                int max_mip, const std::string& source, FrameImages& images,
                                UniformValues& values) {
  const Size padded = paddedSize(images.size(), max_mip);
  const bool is_atlas = layout == PyramidLayout::kAtlas;
  const Size base_size = is_atlas ? atlasSize(images.size(), max_mip) : padded;
  if (std::max(base_size.width, base_size.height) > kMaxImageSide) {
    return inputError("build the depth pyramid",
                      fmt::format("its atlas of {}x{} is over {} texels a side", base_size.width,
                                  base_size.height, kMaxImageSide),
                      "", "use a smaller size or --param form=textbook");
  }
  const auto base = images.getSized({.name = pyramidImage(layout, max_mip, source, images),
                                     .format = Format::kRg32f,
                                     .size = base_size,
                                     .mip_count = is_atlas ? 1 : max_mip + 1});
  if (!base) {
    return tl::make_unexpected(base.error());
  }
  values.set("atlas_rows", 2.0 * padded.height);
  values.set("atlas_texel_uv", 1.0 / glm::dvec2(base_size.width, base_size.height));
  auto sum = makeBase(device, *programs.base, **base, padded, source, images, values);
  if (sum) {
    const auto levels =
        makeLevels(device, *programs.reduce, **base, padded, is_atlas, max_mip, images, values);
    if (!levels) {
      return levels;
    }
    *sum += *levels;
  }
  return sum;
}

}  // namespace ssrkit
