// Where the kit's own files are: the source tree, or the folder that SSRKIT_ROOT names.
#pragma once

#include <filesystem>

namespace ssrkit {

struct KitPaths {
  std::filesystem::path root;
  std::filesystem::path shaders;
  std::filesystem::path scenes;
  std::filesystem::path expectations;
  std::filesystem::path known_failures;  // of the conformance matrix, by driver
  std::filesystem::path conformance;     // the conformance matrix, files as in `expectations`
  std::filesystem::path claims;
  std::filesystem::path goldens;
  std::filesystem::path mutants;
  std::filesystem::path wheats;
  std::filesystem::path battery;  // what mutants are held against
  std::filesystem::path gates;
  std::filesystem::path build;  // where the unit tests are
};

[[nodiscard]] KitPaths kitPaths();

}  // namespace ssrkit
