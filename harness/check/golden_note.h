// The sidecar of a golden as JSON (docs/formats.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/golden.h"

namespace ssrkit {

inline constexpr int kGoldenSchemaVersion = 1;

struct StoredGolden {
  GoldenNote note;
  std::vector<std::string> channels;  // in their order; EXR files sort them
  std::string image_hash;             // hashName() of the EXR file's bytes
};

[[nodiscard]] std::string goldenNoteText(const StoredGolden& stored);

// Strict: an unknown or missing key is an error. `file` is the name that messages show.
[[nodiscard]] Expected<StoredGolden> parseGoldenNote(std::string_view text, const std::string& file);

}  // namespace ssrkit
