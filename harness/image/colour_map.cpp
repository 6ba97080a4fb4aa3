#include "image/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/check.h"

namespace ssrkit {

namespace {

// Viridis (S. van der Walt and N. Smith, 2015, released under CC0) at every 16th of its length, linear
// between.
constexpr std::array<Rgb8, 17> kViridis = {{{0x44, 0x01, 0x54},
                                            {0x48, 0x18, 0x6a},
                                            {0x47, 0x2d, 0x7b},
                                            {0x42, 0x40, 0x86},
                                            {0x3b, 0x52, 0x8b},
                                            {0x33, 0x63, 0x8d},
                                            {0x2c, 0x72, 0x8e},
                                            {0x26, 0x82, 0x8e},
                                            {0x21, 0x91, 0x8c},
                                            {0x1f, 0xa0, 0x88},
                                            {0x28, 0xae, 0x80},
                                            {0x3f, 0xbc, 0x73},
                                            {0x5e, 0xc9, 0x62},
                                            {0x84, 0xd4, 0x4b},
                                            {0xad, 0xdc, 0x30},
                                            {0xd8, 0xe2, 0x19},
                                            {0xfd, 0xe7, 0x25}}};

constexpr Rgb8 kNanColour = {255, 0, 255};

// srgbEncode for pictures: 8-bit results of 2^16 linear values. A linear step is at most 0.05 of an 8-bit
// step.
const std::array<std::uint8_t, 65536>& encodedBytes() {
  static const auto table = [] {
    std::array<std::uint8_t, 65536> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = static_cast<std::uint8_t>(std::lround(255.0 * srgbEncode(static_cast<double>(i) / 65535.0)));
    }
    return bytes;
  }();
  return table;
}

}  // namespace

Rgb8 colourOf(RayClass ray_class) {
  switch (ray_class) {
    case RayClass::kMasked:
      return {128, 128, 128};
    case RayClass::kBackground:
      return okabe_ito::kBlack;
    case RayClass::kHit:
      return okabe_ito::kBluishGreen;
    case RayClass::kOffscreen:
      return okabe_ito::kSkyBlue;
    case RayClass::kRange:
      return okabe_ito::kYellow;
    case RayClass::kBudget:
      return okabe_ito::kVermillion;
    case RayClass::kIntoSurface:
      return okabe_ito::kReddishPurple;
  }
  checkFailed(__FILE__, __LINE__, "a ray class", fmt::format("{}", static_cast<int>(ray_class)));
}

Rgb8 blend(Rgb8 from, Rgb8 to, double weight) {
  Rgb8 mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    mixed[i] = static_cast<std::uint8_t>(std::lround(from[i] + weight * (to[i] - from[i])));
  }
  return mixed;
}

Rgb8 sequentialColour(double t) {
  constexpr double kIntervals = kViridis.size() - 1;
  const double place = t > 0.0 ? std::min(t, 1.0) * kIntervals : 0.0;
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  return blend(kViridis[below], kViridis[below + 1], place - static_cast<double>(below));
}

double srgbEncode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

ByteImage toneMap(const Image& linear, double exposure) {
  const std::size_t channels = linear.channelCount();
  SSRKIT_CHECK(channels == 1 || channels >= 3);
  ByteImage picture(linear.size, 3);
  const auto& encoded = encodedBytes();
  const auto scale = static_cast<float>(exposure);
  for (std::size_t texel = 0; texel < linear.texelCount(); ++texel) {
    const float* const in = &linear.data[texel * channels];
    std::uint8_t* const out = &picture.data[texel * 3];
    for (std::size_t i = 0; i < 3; ++i) {
      const float value = in[channels == 1 ? 0 : i] * scale;
      if (std::isnan(value)) {
        std::ranges::copy(kNanColour, out);
        break;
      }
      out[i] = encoded[static_cast<std::size_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F))];
    }
  }
  return picture;
}

}  // namespace ssrkit
