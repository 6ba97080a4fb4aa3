#pragma once

#include <string>
#include <string_view>

namespace ssrkit {

// Text that XML 1.0 and HTML can hold: bytes that are no UTF-8 and control characters other than tab, line
// feed and carriage return become U+FFFD. Nothing is escaped.
[[nodiscard]] std::string plainUtf8(std::string_view bytes);

}  // namespace ssrkit
