#pragma once

#include <compare>

namespace ssrkit {

// Width and height in texels.
struct Size {
  int width = 0;
  int height = 0;
  auto operator<=>(const Size&) const = default;
};

}  // namespace ssrkit
