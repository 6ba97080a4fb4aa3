#include "frame/pyramid.h"

#include <fmt/format.h>

#include <algorithm>

#include "device/pass_clock.h"

namespace ssrkit {

namespace {

constexpr int kMaxImageSide = 16384;

// Draws level `level` into `target` from `finer`, of which only the mip below is seen.
Expected<PassTime> drawLevel(Device& device, const PyramidPrograms& programs, const Attachment& target,
                             Size size, const SampledImage& finer, const FrameImages& images,
                             const UniformValues& values) {
  return drawFullScreen(device, *programs.reduce,
                        {.row = &pyramidReducePass(),
                         .targets = {target},
                         .viewport = {0, 0, size.width, size.height},
                         .aliases = {{"finer", finer}}},
                        images, values);
}

Size levelSize(Size padded, int level) {
  return {padded.width >> level, padded.height >> level};
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
  const Size base_size = is_atlas ? Size{padded.width, 2 * padded.height} : padded;
  if (std::max(base_size.width, base_size.height) > kMaxImageSide) {
    return inputError("build the depth pyramid",
                      fmt::format("its atlas of {}x{} is over {} texels a side", base_size.width,
                                  base_size.height, kMaxImageSide),
                      "", "use a smaller size or --param form=textbook");
  }
  // Level 0 stands in `base`; in the atlas layout the others are drawn into an image of their own and copied,
  // because an image may not be drawn to and sampled at once.
  const auto base = images.getSized({.name = is_atlas ? "pyramid_atlas" : "pyramid",
                                     .format = Format::kRg32f,
                                     .size = base_size,
                                     .mip_count = is_atlas ? 1 : max_mip + 1});
  if (!base) {
    return tl::make_unexpected(base.error());
  }
  auto sum = drawFullScreen(device, *programs.base,
                            {.row = &pyramidBasePass(),
                             .targets = {{*base, 0, std::nullopt}},
                             .viewport = {0, 0, padded.width, padded.height},
                             .aliases = {{"dist_view", images.sampled(source)}}},
                            images, values);
  if (!sum || max_mip == 0) {
    values.set("atlas_rows", 2.0 * padded.height);
    values.set("atlas_texel_uv", 1.0 / glm::dvec2(base_size.width, base_size.height));
    return sum;
  }
  const auto upper = is_atlas ? images.getSized({.name = "pyramid_upper",
                                                 .format = Format::kRg32f,
                                                 .size = levelSize(padded, 1),
                                                 .mip_count = max_mip})
                              : base;
  if (!upper) {
    return tl::make_unexpected(upper.error());
  }
  for (int level = 1; level <= max_mip; ++level) {
    const int target_mip = is_atlas ? level - 1 : level;
    const SampledImage finer{.image = level == 1 ? *base : *upper,
                             .base_mip = level == 1 ? 0 : target_mip - 1};
    const auto time = drawLevel(device, programs, {*upper, target_mip, std::nullopt},
                                levelSize(padded, level), finer, images, values);
    if (!time) {
      return time;
    }
    *sum += *time;
    if (is_atlas) {
      const PassClock clock;
      const int first_row = 2 * padded.height - (2 * padded.height >> level);
      if (const auto copied = device.copy(**upper, target_mip, **base, 0, first_row); !copied) {
        return tl::make_unexpected(copied.error());
      }
      PassTime time_of_copy = clock.elapsed();
      time_of_copy.device_ns = 0;  // nobody's timestamps tell it
      *sum += time_of_copy;
    }
  }
  values.set("atlas_rows", 2.0 * padded.height);
  values.set("atlas_texel_uv", 1.0 / glm::dvec2(base_size.width, base_size.height));
  return sum;
}

}  // namespace ssrkit
