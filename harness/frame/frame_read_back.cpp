#include "frame/frame_read_back.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "frame/image_transfer.h"

namespace ssrkit {

namespace {

constexpr std::int64_t kMostKeptTexels = std::int64_t{1} << 22;

bool leavesDevice(const std::string& name) {
  const auto rows = frameImages();
  const auto row = std::ranges::find(rows, name, &FrameImageRow::name);
  return row != rows.end() && !row->folder.empty();
}

}  // namespace

bool isLargeFrame(Size size) {
  return std::int64_t{size.width} * size.height > kMostKeptTexels;
}

void dropWhatStays(FrameImages& images, const std::set<std::string>& names) {
  if (!isLargeFrame(images.size())) {
    return;
  }
  for (const std::string& name : images.names()) {
    if (!leavesDevice(name) && !names.contains(name)) {
      images.drop(name);
    }
  }
}

Expected<std::map<std::string, Image>> readFrame(Device& device, FrameImages& images, bool is_given) {
  dropWhatStays(images, {});
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
    if (isLargeFrame(images.size())) {
      images.drop(row.name);
    }
  }
  return result;
}

}  // namespace ssrkit
