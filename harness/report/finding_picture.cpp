#include "report/finding_picture.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/byte_image.h"
#include "image/codec.h"
#include "image/colour_map.h"

namespace ssrkit {

namespace {

// RFC 4648.
std::string base64(std::span<const unsigned char> bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = (group << 8U) | (j < count ? bytes[i + j] : 0U);
    }
    for (std::size_t digit = 0; digit < 4; ++digit) {
      text += digit <= count ? kDigits[(group >> (18U - 6U * static_cast<unsigned>(digit))) & 0x3FU] : '=';
    }
  }
  return text;
}

ByteImage pictureOf(const FindingMap& map) {
  constexpr Rgb8 kGround = {32, 34, 38};
  ByteImage picture(map.size, 3);
  for (std::size_t i = 0; i < map.dots.size(); ++i) {
    const Rgb8 colour =
        map.dots[i] == 0 ? kGround : blend(okabe_ito::kVermillion, okabe_ito::kYellow, map.dots[i] / 255.0);
    std::copy(colour.begin(), colour.end(), picture.data.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return picture;
}

}  // namespace

Expected<std::string> findingPictureBase64(const FindingMap& map) {
  const auto codec = imageCodec();
  if (!codec) {
    return tl::make_unexpected(codec.error());
  }
  std::vector<unsigned char> png;
  if (const std::string problem = (*codec)->encodePng(pictureOf(map), png); !problem.empty()) {
    return setupError("draw the findings of a check", problem);
  }
  return base64(png);
}

}  // namespace ssrkit
