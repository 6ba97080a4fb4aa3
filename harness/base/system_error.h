// Turns errno into the two halves of an error sentence.
#pragma once

#include <filesystem>
#include <string>

namespace ssrkit {

// "No space left on device (ENOSPC)".
[[nodiscard]] std::string errnoInWords(int code);

// What somebody can do about a write to `path` that failed with `code`.
[[nodiscard]] std::string remedyForWriting(const std::filesystem::path& path, int code);

}  // namespace ssrkit
