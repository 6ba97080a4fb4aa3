#include "check/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"

namespace ssrkit {

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  if (const auto nearest = nearestName(word, known)) {
    return fmt::format("did you mean '{}'?", *nearest);
  }
  return fmt::format("known are {}", joinNames(known));
}

FieldReader::FieldReader(const TomlValue& table, std::string label, std::string file, std::string attempted)
    : table_(table), label_(std::move(label)), file_(std::move(file)), attempted_(std::move(attempted)) {}

void FieldReader::allowOnly(std::span<const std::string> keys) {
  for (const TomlEntry& entry : table_.entries) {
    if (std::ranges::find(keys, entry.key) == keys.end()) {
      complainAt(entry.key_place, fmt::format("unknown key '{}' in {}", entry.key, label_),
                 suggestion(entry.key, keys));
    }
  }
}

std::string FieldReader::text(std::string_view key) {
  const std::optional<std::string> found = optionalText(key);
  if (!found) {
    complainMissing(key);
  }
  return found.value_or("");
}

std::optional<std::string> FieldReader::optionalText(std::string_view key) {
  const TomlValue* found = value(key, TomlValue::Kind::kText);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->text.empty()) {
    complainAt(found->place, fmt::format("'{}' is empty", key), "give it a value or leave the key out");
  }
  return found->text;
}

std::vector<std::string> FieldReader::texts(std::string_view key) {
  std::vector<std::string> found = optionalTexts(key);
  if (found.empty()) {
    complainMissing(key);
  }
  return found;
}

std::vector<std::string> FieldReader::optionalTexts(std::string_view key) {
  std::vector<std::string> words;
  const TomlValue* list = value(key, TomlValue::Kind::kArray);
  if (list == nullptr) {
    return words;
  }
  if (list->elements.empty()) {
    complainAt(list->place, fmt::format("the list '{}' is empty", key),
               "name at least one or leave the key out");
  }
  for (const TomlValue& element : list->elements) {
    if (element.kind != TomlValue::Kind::kText) {
      complainAt(element.place, fmt::format("'{}' is a list of text, not of {}", key, name(element.kind)),
                 "");
    } else if (std::ranges::find(words, element.text) != words.end()) {
      complainAt(element.place, fmt::format("'{}' names '{}' twice", key, element.text), "");
    }
    words.push_back(element.text);
  }
  return words;
}

std::optional<double> FieldReader::number(std::string_view key, double low, double high) {
  const TomlEntry* entry = table_.find(key);
  const bool is_integer = entry != nullptr && entry->value.kind == TomlValue::Kind::kInteger;
  const TomlValue* found = value(key, is_integer ? TomlValue::Kind::kInteger : TomlValue::Kind::kFloat);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (std::isnan(found->number) || found->number < low || found->number > high) {
    complainAt(found->place, fmt::format("'{}' is {:g}, outside {:g} to {:g}", key, found->number, low, high),
               "");
  }
  return found->number;
}

std::optional<int> FieldReader::integer(std::string_view key, int low, int high) {
  const TomlValue* found = value(key, TomlValue::Kind::kInteger);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (found->integer < low || found->integer > high) {
    complainAt(found->place, fmt::format("'{}' is {}, outside {} to {}", key, found->integer, low, high), "");
    return std::nullopt;
  }
  return static_cast<int>(found->integer);
}

bool FieldReader::flag(std::string_view key) {
  const TomlValue* found = value(key, TomlValue::Kind::kFlag);
  return found != nullptr && found->flag;
}

void FieldReader::complain(std::string_view key, std::string problem, std::string remedy) {
  const TomlEntry* entry = table_.find(key);
  complainAt(entry != nullptr ? entry->value.place : table_.place, std::move(problem), std::move(remedy));
}

void FieldReader::requireKnown(std::string_view key, std::string_view word, std::string_view what,
                               std::span<const std::string> known) {
  if (std::ranges::find(known, word) == known.end()) {
    complain(key, fmt::format("unknown {} '{}'", what, word), suggestion(word, known));
  }
}

void FieldReader::requirePlainId(std::string_view key, std::string_view word) {
  const bool plain = std::ranges::all_of(word, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
  });
  if (!plain) {
    complain(key, fmt::format("'{}' is no id", word), "use only a-z, 0-9, '.', '_' and '-'");
  }
}

Expected<void> FieldReader::result() const {
  if (error_) {
    return tl::make_unexpected(*error_);
  }
  return {};
}

std::string FieldReader::whereIs(std::string_view key) const {
  const TomlEntry* entry = table_.find(key);
  return placeText(file_, entry != nullptr ? entry->value.place : table_.place);
}

void FieldReader::complainAt(TomlPlace place, std::string problem, std::string remedy) {
  if (!error_) {
    error_ = Error{ErrorKind::kInput,       attempted_,        std::move(problem),
                   placeText(file_, place), std::move(remedy), {}};
  }
}

const TomlValue* FieldReader::value(std::string_view key, TomlValue::Kind wanted) {
  const TomlEntry* entry = table_.find(key);
  if (entry == nullptr) {
    return nullptr;
  }
  if (entry->value.kind != wanted) {
    complainAt(
        entry->value.place,
        fmt::format("'{}' in {} must be {}, not {}", key, label_, name(wanted), name(entry->value.kind)), "");
    return nullptr;
  }
  return &entry->value;
}

void FieldReader::complainMissing(std::string_view key) {
  complainAt(table_.place, fmt::format("{} lacks the key '{}'", label_, key),
             fmt::format("add {} = ...", key));
}

}  // namespace ssrkit
