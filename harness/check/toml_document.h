// A TOML file as plain data with the place of every key and value, so that complaints can point at them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct TomlPlace {
  unsigned line = 0;  // both from 1
  unsigned column = 0;
};

struct TomlEntry;

struct TomlValue {
  enum class Kind : std::uint8_t { kTable, kArray, kText, kInteger, kFloat, kFlag, kDate };

  Kind kind = Kind::kTable;
  TomlPlace place;
  std::vector<TomlEntry> entries;   // kTable, in the order of the file
  std::vector<TomlValue> elements;  // kArray
  std::string text;                 // kText
  std::int64_t integer = 0;         // kInteger
  double number = 0.0;              // kFloat, and kInteger as a number
  bool flag = false;                // kFlag

  [[nodiscard]] const TomlEntry* find(std::string_view key) const;
};

struct TomlEntry {
  std::string key;
  TomlPlace key_place;
  TomlValue value;
};

[[nodiscard]] const char* name(TomlValue::Kind kind);  // "a number"

// "FILE:12:7"
[[nodiscard]] std::string placeText(std::string_view file, TomlPlace place);

// Fails on text that is not TOML, with its place. `file` is the name that messages show.
[[nodiscard]] Expected<TomlValue> parseToml(std::string_view content, const std::string& file,
                                            const std::string& attempted);

}  // namespace ssrkit
