#pragma once

#include <string>
#include <string_view>

namespace ssrkit {

// A name from a file, fit for a line of output: control characters become spaces, both ends are trimmed, and
// what is longer than 120 bytes is cut (at a character) and ends in "...".
[[nodiscard]] std::string cleanName(std::string_view text);

}  // namespace ssrkit
