// Numbers as short text for tables and pictures.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ssrkit {

// "99.98": rounded down, so that only a fraction of exactly 1 reads 100.
[[nodiscard]] std::string percentText(double fraction, int decimals);

// At most five characters: "12345", "230k", "8.3M".
[[nodiscard]] std::string countText(std::size_t count);

// Three or four significant digits without an exponent: "0.042", "12.3", "1234".
[[nodiscard]] std::string measureText(double value);

// Control characters become '?'; cut to `columns` code points, with ".." at the end when something was cut.
[[nodiscard]] std::string cellText(std::string_view text, std::size_t columns);

// The columns that valid UTF-8 of single-width characters takes.
[[nodiscard]] std::size_t columnsOf(std::string_view text);

}  // namespace ssrkit
