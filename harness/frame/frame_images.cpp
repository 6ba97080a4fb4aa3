#include "frame/frame_images.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/check.h"

namespace ssrkit {

namespace {

constexpr double kBackground = std::numeric_limits<double>::infinity();
constexpr std::size_t kGbufferCount = 6;

const std::vector<FrameImageRow>& imageTable() {
  using enum Format;
  const std::vector<std::string> rgb = {"R", "G", "B"};
  const std::vector<std::string> rgba = {"R", "G", "B", "A"};
  static const std::vector<FrameImageRow> rows = {
      // What gbuffer.frag writes, in the order of its outputs.
      {.name = "albedo",
       .format = kRgba16f,
       .channels = rgb,
       .folder = "gbuffer",
       .clear = {0, 0, 0, 1},
       .upload_default = {0.8F, 0.8F, 0.8F, 1}},
      {.name = "normal_view",
       .format = kRgba32f,
       .channels = rgba,
       .folder = "gbuffer",
       .clear = {0, 0, 0, 1},
       .upload_default = {0, 0, 1, 1}},
      {.name = "material",
       .format = kRgba16f,
       .channels = rgb,
       .folder = "gbuffer",
       .clear = {0, 1, 0, 0},  // alpha 0: background
       .upload_default = {1, 0, 1, 1}},
      {.name = "emission",
       .format = kRgba16f,
       .channels = rgb,
       .folder = "gbuffer",
       .clear = {0, 0, 0, 1},
       .upload_default = {0, 0, 0, 1}},
      {.name = "dist_view",
       .format = kR32f,
       .channels = {"Z"},
       .folder = "gbuffer",
       .clear = {kBackground, 0, 0, 0}},
      {.name = "motion", .format = kRg32f, .channels = {"X", "Y"}, .folder = "gbuffer"},
      // What it writes beside them: level 0 of the depth pyramid (frame/pyramid.h).
      {.name = "dist_range", .format = kRg32f, .clear = {kBackground, 0, 0, 0}},
      {.name = "depth_window",
       .format = kD32f,
       .channels = {"Z"},
       .folder = "gbuffer",
       .clear = {1, 0, 0, 0}},
      // The frame's.
      {.name = "lit", .format = kRgba16f, .channels = rgb, .folder = "."},
      {.name = "lit_base", .format = kRgba16f, .channels = rgb, .folder = "."},
      {.name = "shadow", .format = kR32f, .channels = {"V"}, .folder = ".", .clear = {1, 0, 0, 0}},
      {.name = "ao", .format = kR32f, .channels = {"V"}, .folder = ".", .clear = {1, 0, 0, 0}},
      {.name = "ao_noisy", .format = kRg32f, .clear = {1, kBackground, 0, 0}},
      {.name = "ao_blurred", .format = kRg32f, .clear = {1, kBackground, 0, 0}},
      // What a packed G-buffer would hold, and what tracers read of it.
      {.name = "normal_octahedral", .format = kRg16i},
      {.name = "normal_xy_sign", .format = kRgba16ui},
      {.name = "normal_unpacked", .format = kRgba32f, .channels = rgba},
      {.name = "dist_unpacked", .format = kR32f, .channels = {"Z"}},
      // The environment's, of sizes of their own (frame/environment_images.h).
      {.name = "environment", .format = kRgba16f, .filter = Filter::kLinear},
      {.name = "irradiance", .format = kRgba16f, .filter = Filter::kLinear},
      {.name = "split_sum", .format = kRg32f, .filter = Filter::kLinear},
      // A trace's.
      {.name = "hit_texel", .format = kRg16i, .clear = {-1, -1}},
      {.name = "hit_point", .format = kRgba32f, .clear = {-1, -1, -1, 0}},
      {.name = "ray_work", .format = kRgba16ui},
      {.name = "ray_depth", .format = kD32f, .clear = {1, 0, 0, 0}},
      {.name = "hit_texel_half", .format = kRg16i, .clear = {-1, -1}, .divisor = 2},
      {.name = "hit_point_half", .format = kRgba32f, .clear = {-1, -1, -1, 0}, .divisor = 2},
      {.name = "ray_work_half", .format = kRgba16ui, .divisor = 2},
      {.name = "ray_depth_half", .format = kD32f, .clear = {1, 0, 0, 0}, .divisor = 2},
      // A technique's.
      {.name = "microfacet_normal", .format = kRgba32f, .channels = rgba},
      {.name = "ray_material", .format = kRgba16f, .channels = rgb},
      {.name = "ray_end", .format = kRgba32f},
      {.name = "ray_radiance", .format = kRgba32f},
      {.name = "ray_density", .format = kRg32f},
      {.name = "reflection_reused", .format = kRgba16f, .channels = rgba},
      {.name = "variance_reused", .format = kR32f},
      {.name = "reflection_near", .format = kRgba16f, .channels = rgba},
      {.name = "variance_near", .format = kR32f},
      {.name = "reflection_variance", .format = kR32f},
      {.name = "reflected_sum", .format = kRgba32f},
      {.name = "reflected_sum_next", .format = kRgba32f},
      {.name = "weight_sum", .format = kR32f},
      {.name = "weight_sum_next", .format = kR32f},
      {.name = "reflection_half", .format = kRgba32f, .divisor = 2},
      {.name = "reflection", .format = kRgba16f, .channels = rgba},
      {.name = "reflection_weighed", .format = kRgba16f, .channels = rgba},
      {.name = "visibility", .format = kR32f, .channels = {"Y"}},
      {.name = "material_masked", .format = kRgba16f, .channels = rgb},
      {.name = "lit_mips", .format = kRgba16f, .has_mips = true, .filter = Filter::kLinear},
      {.name = "blur_guide", .format = kRg32f},
      {.name = "reflection_blurred_x", .format = kRgba16f},
      {.name = "reflection_blurred", .format = kRgba16f},
      {.name = "reflection_blurred_wide", .format = kRgba16f, .channels = rgba},
      {.name = "known", .format = kRgba16f, .has_mips = true},
      {.name = "reflection_filled", .format = kRgba16f, .channels = rgba},
      // 32 bits: drivers round halves towards zero, and an average of averages would darken from frame to
      // frame.
      {.name = "accumulated", .format = kRgba32f, .channels = rgba},
      {.name = "history_length", .format = kR32f, .channels = {"Y"}},
      // The previous frame's. Without one nothing was seen: a surface at distance 0 is nobody's past.
      {.name = "previous_lit", .format = kRgba16f, .previous_of = "lit"},
      {.name = "previous_dist_view", .format = kR32f, .previous_of = "dist_view"},
      {.name = "previous_accumulated", .format = kRgba32f, .previous_of = "accumulated"},
      {.name = "previous_history_length", .format = kR32f, .previous_of = "history_length"},
      {.name = "composite", .format = kRgba16f, .channels = rgb},
      // A peer's.
      {.name = "peer_depth", .format = kR32f},
      {.name = "peer_depth_mips", .format = kR32f, .has_mips = true},
      {.name = "peer_normal", .format = kRgba32f},
      {.name = "peer_answer", .format = kRgba32f},
      // What the rooflines compute, which nobody needs.
      {.name = "roofline_dependent_fetch", .format = kR32f, .channels = {"V"}},
      {.name = "roofline_fetch", .format = kR32f, .channels = {"V"}},
      {.name = "roofline_alu", .format = kR32f, .channels = {"V"}},
  };
  return rows;
}

// Null for images of a size of their own, which have no row.
const FrameImageRow* findImageRow(std::string_view name) {
  const auto found = std::ranges::find(imageTable(), name, &FrameImageRow::name);
  return found == imageTable().end() ? nullptr : &*found;
}

}  // namespace

std::span<const FrameImageRow> frameImages() {
  return imageTable();
}

std::span<const FrameImageRow> gbufferImages() {
  return std::span(imageTable()).first(kGbufferCount);
}

const FrameImageRow& frameImageRow(std::string_view name) {
  if (const FrameImageRow* row = findImageRow(name)) {
    return *row;
  }
  checkFailed(__FILE__, __LINE__, "a frame image of this name exists", name);
}

Expected<DeviceImage*> FrameImages::get(const std::string& name) {
  return getSized(descOf(name, name));
}

ImageDesc FrameImages::descOf(const std::string& row_name, const std::string& name) const {
  const FrameImageRow& row = frameImageRow(row_name);
  const Size size{(size_.width + row.divisor - 1) / row.divisor,
                  (size_.height + row.divisor - 1) / row.divisor};
  const auto longer_side = static_cast<unsigned>(std::max(size.width, size.height));
  return {.name = name,
          .format = row.format,
          .size = size,
          .mip_count = row.has_mips ? static_cast<int>(std::bit_width(longer_side)) : 1};
}

SampledImage FrameImages::sampled(const std::string& name) const {
  const DeviceImage* image = find(name);
  const FrameImageRow* row = findImageRow(name);
  return {.image = image,
          .mip_count = image != nullptr ? image->desc().mip_count : 1,
          .filter = row != nullptr ? row->filter : Filter::kNearest};
}

Expected<DeviceImage*> FrameImages::getSized(const ImageDesc& desc) {
  std::unique_ptr<DeviceImage>& slot = images_[desc.name];
  const bool fits =
      slot != nullptr && slot->desc().size == desc.size && slot->desc().mip_count == desc.mip_count;
  if (!fits) {
    slot.reset();
    auto created = device_.createImage(desc);
    if (!created) {
      images_.erase(desc.name);
      return tl::make_unexpected(created.error());
    }
    slot = std::move(*created);
  }
  return slot.get();
}

void FrameImages::swap(const std::string& one, const std::string& other) {
  SSRKIT_CHECK(find(one) != nullptr && find(other) != nullptr);
  std::swap(images_.at(one), images_.at(other));
}

DeviceImage* FrameImages::find(const std::string& name) const {
  const auto found = images_.find(name);
  return found == images_.end() ? nullptr : found->second.get();
}

std::vector<std::string> FrameImages::names() const {
  std::vector<std::string> list;
  for (const auto& [name, image] : images_) {
    list.push_back(name);
  }
  return list;
}

}  // namespace ssrkit
