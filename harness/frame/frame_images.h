// The named images of a frame, as rows of data, and their device images at one size.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "device/device.h"

namespace ssrkit {

struct FrameImageRow {
  std::string name;
  Format format = Format::kRgba16f;
  std::vector<std::string> channels = {};  // of the EXR file; empty: never leaves the device
  std::string folder =
      {};  // where in DIR/SCENE/DEVICE all traces' images are written; empty: one trace's image
  std::string previous_of = {};  // the image that this is one frame earlier; then `clear` says: no history
  std::array<double, 4> clear{};
  std::array<float, 4> upload_default{};  // what a G-buffer made by others has where it lacks this image
  int divisor = 1;                        // sides are the frame's over this, rounded up
  bool has_mips = false;                  // the whole chain, down to one texel
  Filter filter = Filter::kNearest;       // how passes sample it
};

[[nodiscard]] std::span<const FrameImageRow> frameImages();

// The G-buffer's colour images in the order of gbuffer.frag's outputs.
[[nodiscard]] std::span<const FrameImageRow> gbufferImages();

// The row of any image of the frame; the name must exist.
[[nodiscard]] const FrameImageRow& frameImageRow(std::string_view name);

// Device images by name, created at the first use.
class FrameImages {
 public:
  FrameImages(Device& device, Size size) : device_(device), size_(size) {}

  // A row's image, at the frame's size over the row's divisor.
  [[nodiscard]] Expected<DeviceImage*> get(const std::string& name);

  // The size, format and mips of a row's image, under a name.
  [[nodiscard]] ImageDesc descOf(const std::string& row_name, const std::string& name) const;

  // An image of a size and format of its own (pyramids, textures), under a name of its own.
  [[nodiscard]] Expected<DeviceImage*> getSized(const ImageDesc& desc);

  // Two images that are there change names.
  void swap(const std::string& one, const std::string& other);

  // Frees an image that nothing is drawn to or read from any more.
  void drop(const std::string& name) { images_.erase(name); }

  // nullptr when it was never created.
  [[nodiscard]] DeviceImage* find(const std::string& name) const;

  // The same with all of its mips and its row's filter, as passes sample it; no image when there is none.
  [[nodiscard]] SampledImage sampled(const std::string& name) const;

  [[nodiscard]] Size size() const { return size_; }
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  Device& device_;
  Size size_;
  std::map<std::string, std::unique_ptr<DeviceImage>> images_;
};

}  // namespace ssrkit
