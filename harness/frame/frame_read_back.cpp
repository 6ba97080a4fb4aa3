#include "frame/frame_read_back.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "frame/image_transfer.h"

namespace ssrkit {

namespace {

constexpr std::int64_t kMostKeptTexels = std::int64_t{1} << 22;

void dropWhatStays(FrameImages& images) {
  const auto rows = frameImages();
  for (const std::string& name : images.names()) {
    const auto row = std::ranges::find(rows, name, &FrameImageRow::name);
    if (row == rows.end() || row->folder.empty()) {
      images.drop(name);
    }
  }
}

}  // namespace

bool isLargeFrame(Size size) {
  return std::int64_t{size.width} * size.height > kMostKeptTexels;
}

Expected<std::map<std::string, Image>> readFrame(Device& device, FrameImages& images, bool is_given) {
  const bool is_large = isLargeFrame(images.size());
  if (is_large) {
    dropWhatStays(images);
  }
  std::map<std::string, Image> result;
  for (const FrameImageRow& row : frameImages()) {
    const DeviceImage* image = images.find(row.name);
    if (row.folder.empty() || image == nullptr || (row.name == "depth_window" && is_given)) {
      continue;
    }
    auto read = readImage(device, *image, row.channels);
    if (!read) {
      return tl::make_unexpected(read.error());
    }
    result.emplace(row.name, std::move(*read));
    if (is_large) {
      images.drop(row.name);
    }
  }
  return result;
}

}  // namespace ssrkit
