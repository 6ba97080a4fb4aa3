// A mutant: the kit with one known mistake in one file. A wheat: the kit with one change that is none.
#pragma once

#include <filesystem>
#include <string>

namespace ssrkit {

// The one place of `file` that reads `replace` reads `with` instead.
struct TextEdit {
  std::filesystem::path file;  // from the kit's root: "shaders/include/ssr_march_hiz.glsl"
  std::string replace;
  std::string with;
};

struct Mutant {
  std::string name;  // its TOML file's
  bool is_wheat = false;
  std::string about;      // the mistake; of a wheat, why it is none
  std::string signature;  // what the mistake looks like to the checks; empty for a wheat
  std::string killed_by;  // the check that is to notice it: "TracersTest.Name", "tracers.closed_form"
  TextEdit edit;          // without `replace`: the whole file is replaced by `shader`
  std::filesystem::path shader;
  std::string where;  // of its TOML file, for messages
};

// It changes C++ of the harness, not a shader.
[[nodiscard]] inline bool isOfHarness(const Mutant& mutant) {
  return !mutant.edit.file.empty() && *mutant.edit.file.begin() == "harness";
}

// Names of unit tests begin with a capital letter, those of expectations never do.
[[nodiscard]] inline bool isUnitTest(const std::string& check) {
  return !check.empty() && check.front() >= 'A' && check.front() <= 'Z';
}

}  // namespace ssrkit
