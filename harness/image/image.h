// Images on the host: interleaved float32, origin upper left, as in every file of the kit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/check.h"
#include "base/size.h"

namespace ssrkit {

// `channels` names the channels in order, e.g. {"R","G","B"} or {"texel.x","texel.y"}; integers are stored as
// floats, exact up to 2^24.
struct Image {
  Size size;
  std::vector<std::string> channels;
  std::vector<float> data;  // size.height * size.width * channels.size()

  Image() = default;
  Image(Size image_size, std::vector<std::string> channel_names)
      : size(image_size),
        channels(std::move(channel_names)),
        data(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * channels.size()) {
  }

  [[nodiscard]] std::size_t channelCount() const { return channels.size(); }
  [[nodiscard]] std::size_t texelCount() const {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  }
  [[nodiscard]] std::size_t index(int x, int y, std::size_t channel = 0) const {
    SSRKIT_CHECK_LT(static_cast<unsigned>(x), static_cast<unsigned>(size.width));
    SSRKIT_CHECK_LT(static_cast<unsigned>(y), static_cast<unsigned>(size.height));
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
            static_cast<std::size_t>(x)) *
               channels.size() +
           channel;
  }
  [[nodiscard]] float at(int x, int y, std::size_t channel = 0) const { return data[index(x, y, channel)]; }
  [[nodiscard]] float& at(int x, int y, std::size_t channel = 0) { return data[index(x, y, channel)]; }
};

}  // namespace ssrkit
