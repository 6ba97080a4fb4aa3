#include "frame/frame_images.h"

#include <limits>

#include "base/check.h"

namespace ssrkit {

namespace {

constexpr double kBackground = std::numeric_limits<double>::infinity();
constexpr std::size_t kGbufferCount = 5;

const std::vector<FrameImageRow>& table() {
  static const std::vector<FrameImageRow> rows = {
      {"albedo", Format::kRgba16f, {"R", "G", "B"}, {0, 0, 0, 1}, {0.8F, 0.8F, 0.8F, 1}},
      {"normal_view", Format::kRgba32f, {"R", "G", "B", "A"}, {0, 0, 0, 1}, {0, 0, 1, 1}},
      {"material", Format::kRgba16f, {"R", "G", "B"}, {0, 1, 0, 1}, {1, 0, 1, 1}},
      {"emission", Format::kRgba16f, {"R", "G", "B"}, {0, 0, 0, 1}, {0, 0, 0, 1}},
      {"dist_view", Format::kR32f, {"Z"}, {kBackground, 0, 0, 0}, {}},
      {"depth_window", Format::kD32f, {"Z"}, {1, 0, 0, 0}, {}},
      {"lit", Format::kRgba16f, {"R", "G", "B"}, {}, {}},
      {"hit_texel", Format::kRg16i, {}, {}, {}},
      {"hit_point", Format::kRgba32f, {}, {}, {}},
      {"ray_work", Format::kRgba16ui, {}, {}, {}},
      {"reflection", Format::kRgba16f, {"R", "G", "B", "A"}, {}, {}},
      {"composite", Format::kRgba16f, {"R", "G", "B"}, {}, {}},
  };
  return rows;
}

}  // namespace

std::span<const FrameImageRow> gbufferImages() {
  return std::span(table()).first(kGbufferCount);
}

const FrameImageRow& frameImageRow(std::string_view name) {
  for (const FrameImageRow& row : table()) {
    if (row.name == name) {
      return row;
    }
  }
  checkFailed(__FILE__, __LINE__, "a frame image of this name exists", name);
}

Expected<DeviceImage*> FrameImages::get(const std::string& name) {
  const FrameImageRow& row = frameImageRow(name);
  return getSized({.name = name, .format = row.format, .size = size_, .mip_count = 1});
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
