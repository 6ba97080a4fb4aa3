// Walking the words of a SPIR-V module (SPIR-V specification, section 2.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace ssrkit {

struct Instruction {
  std::uint32_t opcode = 0;
  std::span<const std::uint32_t> operands;
};

// Calls `visit` on every instruction in order; stops at one that does not fit the span.
template <class Visit>
void forEachInstruction(std::span<const std::uint32_t> spirv, const Visit& visit) {
  constexpr std::size_t kHeaderWords = 5;
  constexpr std::uint32_t kOpcodeMask = 0xFFFF;
  constexpr int kCountShift = 16;
  for (std::size_t at = kHeaderWords; at < spirv.size();) {
    const std::size_t count = spirv[at] >> kCountShift;
    if (count == 0 || count > spirv.size() - at) {
      return;
    }
    visit(Instruction{spirv[at] & kOpcodeMask, spirv.subspan(at + 1, count - 1)});
    at += count;
  }
}

// Four characters a word, the first in the low byte, up to a zero.
[[nodiscard]] inline std::string literalString(std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) {
      const char c = static_cast<char>((word >> shift) & 0xFFU);
      if (c == '\0') {
        return text;
      }
      text += c;
    }
  }
  return text;
}

}  // namespace ssrkit
