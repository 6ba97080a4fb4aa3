#include "check/size_text.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "base/text.h"

namespace ssrkit {

std::optional<Size> parseSize(std::string_view text) {
  const std::vector<std::string> sides = split(text, 'x');
  if (sides.size() != 2) {
    return std::nullopt;
  }
  std::array<int, 2> parsed{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<double> number = parseNumber(sides[i]);
    constexpr double kLargestSide = 16384.0;
    if (!number || *number < 1.0 || *number > kLargestSide || *number != static_cast<int>(*number)) {
      return std::nullopt;
    }
    parsed.at(i) = static_cast<int>(*number);
  }
  return Size{parsed[0], parsed[1]};
}

std::string sizeText(Size size) {
  return fmt::format("{}x{}", size.width, size.height);
}

}  // namespace ssrkit
