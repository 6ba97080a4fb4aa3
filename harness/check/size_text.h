// Sizes as expectation files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/size.h"

namespace ssrkit {

// "640x360"; both sides 1..16384.
[[nodiscard]] std::optional<Size> parseSize(std::string_view text);
[[nodiscard]] std::string sizeText(Size size);

}  // namespace ssrkit
