// Pictures for people: 8 bits a channel, sRGB-encoded, origin upper left.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/size.h"

namespace ssrkit {

using Rgb8 = std::array<std::uint8_t, 3>;

struct ByteImage {
  Size size;
  int channel_count = 3;           // 3: RGB, 4: RGBA with alpha not multiplied in
  std::vector<std::uint8_t> data;  // size.height * size.width * channel_count

  ByteImage() = default;
  ByteImage(Size image_size, int channels)
      : size(image_size), channel_count(channels), data(texelCount() * static_cast<std::size_t>(channels)) {}

  [[nodiscard]] std::size_t texelCount() const {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  }
  // Of the texel's first channel. Not checked: for loops over a known rectangle.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
            static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channel_count);
  }
};

}  // namespace ssrkit
