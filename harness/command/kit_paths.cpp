#include "command/kit_paths.h"

#include <cstdlib>

namespace ssrkit {

KitPaths kitPaths() {
  const char* const given = std::getenv("SSRKIT_ROOT");
  const std::filesystem::path root = given != nullptr ? given : SSRKIT_SOURCE_DIR;
  return {.root = root,
          .shaders = root / "shaders",
          .scenes = root / "scenes",
          .expectations = root / "tests" / "expect",
          .known_failures = root / "tests" / "known_failures.toml",
          .conformance = root / "tests" / "conform",
          .claims = root / "tests" / "claims",
          .goldens = root / "tests" / "goldens",
          .mutants = root / "tests" / "mutants",
          .wheats = root / "tests" / "wheats",
          .battery = root / "tests" / "mutants" / "battery",
          .gates = root / "tests" / "gates",
          .build = SSRKIT_BUILD_DIR};
}

}  // namespace ssrkit
