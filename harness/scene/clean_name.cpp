#include "scene/clean_name.h"

#include <algorithm>

namespace ssrkit {

std::string cleanName(std::string_view text) {
  constexpr std::size_t kMaxBytes = 120;
  std::string name(text.substr(0, 4 * kMaxBytes));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; },
      ' ');
  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos) {
    return "";
  }
  name = name.substr(first, name.find_last_not_of(' ') - first + 1);
  if (name.size() <= kMaxBytes) {
    return name;
  }
  std::size_t cut = kMaxBytes;
  while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0U) == 0x80U) {
    --cut;  // not inside a UTF-8 character
  }
  return name.substr(0, cut) + "...";
}

}  // namespace ssrkit
