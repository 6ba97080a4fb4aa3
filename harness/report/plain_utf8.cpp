#include "report/plain_utf8.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ssrkit {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// The length that a lead byte announces; 0 for a byte that begins no character.
std::size_t announcedLength(std::uint32_t lead) {
  if (lead < 0x80) {
    return 1;
  }
  if (lead >= 0xC0 && lead < 0xE0) {
    return 2;
  }
  return lead >= 0xE0 && lead < 0xF0 ? 3 : lead >= 0xF0 && lead < 0xF8 ? 4 : 0;
}

// XML 1.0, production 2, given the shortest form's least code point.
bool isAllowed(std::uint32_t code, std::uint32_t least) {
  if (code < 0x20) {
    return code == '\t' || code == '\n' || code == '\r';
  }
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  return code >= least && code != 0x7F && code <= 0x10FFFF && !is_surrogate && code != 0xFFFE &&
         code != 0xFFFF;
}

// The length of the character that `bytes` begin with; 0 when it is none that text may hold.
std::size_t characterLength(std::string_view bytes) {
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  constexpr std::array<std::uint32_t, 5> kLeadBits = {0, 0x7F, 0x1F, 0x0F, 0x07};
  const auto lead = static_cast<unsigned char>(bytes.front());
  const std::size_t length = announcedLength(lead);
  if (length == 0 || length > bytes.size()) {
    return 0;
  }
  std::uint32_t code = lead & kLeadBits.at(length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if ((byte & 0xC0U) != 0x80U) {
      return 0;
    }
    code = (code << 6U) | (byte & 0x3FU);
  }
  return isAllowed(code, kLeast.at(length)) ? length : 0;
}

}  // namespace

std::string plainUtf8(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t length = characterLength(bytes);
    text += length > 0 ? bytes.substr(0, length) : kReplacement;
    bytes.remove_prefix(length > 0 ? length : 1);
  }
  return text;
}

}  // namespace ssrkit
