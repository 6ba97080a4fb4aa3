#include "base/size.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace ssrkit {

std::string sizeText(Size size) {
  return fmt::format("{}x{}", size.width, size.height);
}

std::optional<Size> parseSize(std::string_view text) {
  Size size;
  const char* const end = text.data() + text.size();
  const auto [after_width, no_width] = std::from_chars(text.data(), end, size.width);
  if (no_width != std::errc() || after_width == end) {
    return std::nullopt;
  }
  const auto [after_height, no_height] = std::from_chars(after_width + 1, end, size.height);
  const bool is_in_range =
      size.width >= 1 && size.width <= kMaxImageSide && size.height >= 1 && size.height <= kMaxImageSide;
  // Written in one way only, so that sizes may be compared as text: no "064x36", no "64X36".
  const bool is_plain = no_height == std::errc() && after_height == end && sizeText(size) == text;
  return is_in_range && is_plain ? std::optional(size) : std::nullopt;
}

}  // namespace ssrkit
