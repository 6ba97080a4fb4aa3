#include "check/toml_document.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

namespace ssrkit {

namespace {

TomlPlace placeOf(const toml::source_region& region) {
  return {region.begin.line, region.begin.column};
}

TomlValue convert(const toml::node& node);

void fillTable(TomlValue& value, const toml::table& table) {
  for (const auto& [key, child] : table) {
    value.entries.push_back({std::string(key.str()), placeOf(key.source()), convert(child)});
  }
  // toml++ sorts by key; complaints and cases keep the order of the file.
  std::ranges::sort(value.entries, {}, [](const TomlEntry& entry) {
    return std::tuple(entry.key_place.line, entry.key_place.column);
  });
}

TomlValue convert(const toml::node& node) {
  TomlValue value;
  value.place = placeOf(node.source());
  if (const toml::table* table = node.as_table()) {
    value.kind = TomlValue::Kind::kTable;
    fillTable(value, *table);
  } else if (const toml::array* array = node.as_array()) {
    value.kind = TomlValue::Kind::kArray;
    for (const toml::node& element : *array) {
      value.elements.push_back(convert(element));
    }
  } else if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::kText;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = TomlValue::Kind::kInteger;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = TomlValue::Kind::kFloat;
    value.number = number->get();
  } else if (const auto* flag = node.as_boolean()) {
    value.kind = TomlValue::Kind::kFlag;
    value.flag = flag->get();
  } else {
    value.kind = TomlValue::Kind::kDate;
  }
  return value;
}

}  // namespace

const TomlEntry* TomlValue::find(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &TomlEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

const char* name(TomlValue::Kind kind) {
  switch (kind) {
    case TomlValue::Kind::kTable:
      return "a table";
    case TomlValue::Kind::kArray:
      return "a list";
    case TomlValue::Kind::kText:
      return "text";
    case TomlValue::Kind::kInteger:
      return "an integer";
    case TomlValue::Kind::kFloat:
      return "a number";
    case TomlValue::Kind::kFlag:
      return "true or false";
    case TomlValue::Kind::kDate:
      return "a date or time";
  }
  return "unknown";
}

std::string placeText(std::string_view file, TomlPlace place) {
  return fmt::format("{}:{}:{}", file, place.line, place.column);
}

Expected<TomlValue> parseToml(std::string_view content, const std::string& file,
                              const std::string& attempted) {
  try {
    return convert(toml::parse(content, file));
  } catch (const toml::parse_error& error) {
    return inputError(attempted, std::string(error.description()), placeText(file, placeOf(error.source())));
  }
}

}  // namespace ssrkit
