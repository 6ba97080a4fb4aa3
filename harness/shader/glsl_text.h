// Reading GLSL as text, without a compiler.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace ssrkit {

// What no shader of the kit comes near; glslang's time and memory grow faster than its input.
inline constexpr std::size_t kSourceLimitBytes = std::size_t{1} << 20;

// The same text with every comment blanked by spaces. Lines and columns stay where they are.
[[nodiscard]] std::string blankComments(std::string_view text);

struct IncludeLine {
  std::string name;
  int line = 0;  // from 1
};

// The #include directives outside comments, in order. Conditionals are not evaluated.
[[nodiscard]] std::vector<IncludeLine> findIncludeLines(std::string_view text);

// Column, from 1, where `token` first stands in the line as a token of its own; nothing when it does not.
[[nodiscard]] std::optional<int> findColumn(std::string_view text, int line, std::string_view token);

// The text as the compiler is to see it: no byte order mark, lines that end in '\n'. `problem` of the error
// says what makes the bytes not a text.
[[nodiscard]] Expected<std::string> normaliseText(std::string bytes);

}  // namespace ssrkit
