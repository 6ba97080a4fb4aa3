#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace ssrkit {

// Width and height in texels.
struct Size {
  int width = 0;
  int height = 0;
  auto operator<=>(const Size&) const = default;
};

// Of every image, in texels.
inline constexpr int kMaxImageSide = 16384;

[[nodiscard]] std::string sizeText(Size size);  // "640x360"

// What sizeText writes and nothing else; both sides from 1 to kMaxImageSide.
[[nodiscard]] std::optional<Size> parseSize(std::string_view text);

}  // namespace ssrkit
