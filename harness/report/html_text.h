#pragma once

#include <string>
#include <string_view>

namespace ssrkit {

// Text as it may stand in HTML, between tags or in a quoted attribute.
[[nodiscard]] std::string htmlText(std::string_view text);

}  // namespace ssrkit
