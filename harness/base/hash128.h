// Names for contents. Two 64-bit hashes of different build, so that a chance collision in one is none in the
// other. Not against an attacker: whoever writes the cache folder can write anything there anyway.
#pragma once

#include <string>
#include <string_view>

namespace ssrkit {

// 32 hexadecimal digits.
[[nodiscard]] std::string hashName(std::string_view bytes);

}  // namespace ssrkit
