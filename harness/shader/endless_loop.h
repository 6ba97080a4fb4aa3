// Loops that can only be left by killing the process: found before a driver hangs on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace ssrkit {

// The place, among the module's loops in order, of the first loop that no path leaves: no branch out of it,
// no return, no discard. Conditions that are constants count as decided; all others as free. The words must
// be a whole SPIR-V module (every instruction inside the span), as a compiler emits it.
[[nodiscard]] std::optional<std::size_t> findEndlessLoop(std::span<const std::uint32_t> spirv);

struct LineOfSource {
  std::string file;  // as OpString names it
  int line = 0;
};

// Where the loop of that place stands, in a module with OpLine.
[[nodiscard]] std::optional<LineOfSource> findLineOfLoop(std::span<const std::uint32_t> spirv,
                                                         std::size_t loop_index);

}  // namespace ssrkit
