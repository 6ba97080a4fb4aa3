// `ssrkit compile FILE`: what the compiler says about one shader, for both APIs.
#pragma once

#include <filesystem>

#include "base/error.h"

namespace ssrkit {

struct CompileCommandOptions {
  std::filesystem::path file;
  std::filesystem::path shader_root;  // where the kit's own includes are
  std::filesystem::path out;          // where what the drivers are given is written; empty: nowhere
  bool json = false;
  bool optimise = false;
  bool use_colour = false;
};

// Prints to standard output. 0 when it compiles for every target, 2 when it does not for one; an error only
// when there is nothing to compile (no such file, a stage that nobody can tell).
[[nodiscard]] Expected<int> compileCommand(const CompileCommandOptions& options);

}  // namespace ssrkit
