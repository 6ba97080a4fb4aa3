// What `ssrkit bless` did, for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "check/golden.h"

namespace ssrkit {

// Of `bless --json` (docs/formats.md); raised when a reader of the older version would be misled.
inline constexpr int kBlessSchemaVersion = 1;

struct BlessedGolden {
  GoldenNote note;
  std::filesystem::path file;  // from the root of the kit
  std::string change;          // changeText
};

[[nodiscard]] std::string blessJson(const std::string& test, const std::vector<BlessedGolden>& goldens);

}  // namespace ssrkit
