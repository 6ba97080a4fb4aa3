// The shaders that the tests draw with: the kit's, or a mutant's (docs/mutants.md).
#pragma once

#include <cstdlib>
#include <filesystem>

namespace ssrkit {

inline std::filesystem::path kitShaders() {
  const char* const mutant = std::getenv("SSRKIT_SHADERS");
  return mutant != nullptr ? std::filesystem::path(mutant)
                           : std::filesystem::path(SSRKIT_SOURCE_DIR) / "shaders";
}

}  // namespace ssrkit
