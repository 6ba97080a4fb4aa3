// The compiler's log in the author's terms: file, line, column, and the words of GLSL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "shader/source_tree.h"

namespace ssrkit {

// The name that glslang is given for the tree's file: free of colons, blanks and quotes.
[[nodiscard]] std::string neutralName(std::size_t file_index);
[[nodiscard]] std::optional<std::size_t> fileIndex(std::string_view neutral_name);

// "file:line"
[[nodiscard]] std::string placeInTree(const SourceTree& tree, std::size_t file_index, int line);

// One error for a log of "ERROR: NAME:LINE: 'TOKEN' : MESSAGE" lines: the first is the problem, all are
// reasons.
[[nodiscard]] Error errorFromLog(std::string_view log, const SourceTree& tree, const std::string& attempted);

}  // namespace ssrkit
