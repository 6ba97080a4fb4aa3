// Small helpers on text that more than one room needs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ssrkit {

// The candidate nearest to `word` by edit distance, when it is near enough to be a slip of the keyboard.
[[nodiscard]] std::optional<std::string> nearestName(std::string_view word,
                                                     std::span<const std::string> candidates);

// "a, b and c"
[[nodiscard]] std::string joinNames(std::span<const std::string> names);

[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

// A finite number or inf/infinity; nothing after it. Independent of the locale.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

// 64-bit FNV-1a of the bytes: names cache entries and seeds, not for secrets.
[[nodiscard]] unsigned long long hashBytes(std::string_view bytes);

}  // namespace ssrkit
