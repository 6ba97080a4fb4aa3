// Reads expectation files. Strict: an unknown key, a wrong type, a missing key, a metric that cannot be held
// against its truth, or an id given twice is an error with file, line and column.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"
#include "check/toml_document.h"

namespace ssrkit {

// The names that a file may use. An empty list allows any.
struct KnownNames {
  std::vector<std::string> scenes;
  std::vector<std::string> devices;
  std::vector<std::string> stages;
  std::vector<std::string> frames;
  std::vector<std::string> techniques;
  std::vector<std::string> variants;
  // "P", "R" or "X": how alike two devices' answers must be; what `pair` in a file means. Empty: nobody
  // knows.
  std::function<std::string(const std::string& a, const std::string& b)> tolerance_class;
};

// What files that are more than expectations (claims) allow beyond them.
struct ReadRules {
  std::vector<std::string> top_keys;     // sections of the file beside [test], [[case]] and [[expect]]
  std::vector<std::string> expect_keys;  // keys of [[expect]]
  bool needs_bounds = true;  // false: without any, an expectation has none, not even its metric's own
};

// One file's content. `file` is the name that messages show.
[[nodiscard]] Expected<TestFile> readExpectations(std::string_view content, const std::string& file,
                                                  const KnownNames& known = {});

// The same of a document that has been parsed; its other sections are the caller's.
[[nodiscard]] Expected<TestFile> readExpectations(const TomlValue& document, const std::string& file,
                                                  const KnownNames& known, const ReadRules& rules);

// Every *.toml of a folder, sorted by name, or the one file. Fails when there is none.
[[nodiscard]] Expected<std::vector<std::filesystem::path>> tomlFiles(const std::filesystem::path& path,
                                                                     const std::string& attempted);

// Every *.toml of a folder, sorted by name, or one file. Fails when there is none, and when two files have
// the same id.
[[nodiscard]] Expected<std::vector<TestFile>> loadExpectations(const std::filesystem::path& path,
                                                               const KnownNames& known = {});

}  // namespace ssrkit
