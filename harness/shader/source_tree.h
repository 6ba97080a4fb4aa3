// An entry file and every file that it may include, read once: what is hashed is what is compiled.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "shader/compiler.h"

namespace ssrkit {

// One #include directive. A refusal is an error only when the compiler comes by it: it may stand inside `#if
// 0`.
struct IncludeEdge {
  std::string name;
  int line = 0;
  std::optional<std::size_t> target;  // index into SourceTree::files
  std::string refusal;                // why there is no target
};

struct SourceFile {
  std::filesystem::path path;  // canonical
  std::string shown_path;      // as people should read it in messages
  std::string text;            // without byte order mark, lines end in '\n'
  std::vector<IncludeEdge> includes;
};

struct SourceTree {
  std::vector<SourceFile> files;  // entry first
};

// Reads the entry and follows its includes by the rules of ShaderSource. `attempted` is for the error's
// words.
[[nodiscard]] Expected<SourceTree> readSourceTree(const ShaderSource& source, const std::string& attempted);

// The path under the current folder when it lies there, else the path as it is.
[[nodiscard]] std::string shownPath(const std::filesystem::path& path);

}  // namespace ssrkit
