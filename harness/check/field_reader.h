// Strict reading of one TOML table: every key must be known, of its type, and within its range. The first
// complaint is kept and ends the reading, so that callers read all fields in a row and ask once.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/toml_document.h"

namespace ssrkit {

// For FieldReader::number(): any finite number is within -kUnlimited and kUnlimited.
inline constexpr double kUnlimited = std::numeric_limits<double>::max();

class FieldReader {
 public:
  // `table` must outlive the reader. `label` names it in complaints: "[[expect]]".
  FieldReader(const TomlValue& table, std::string label, std::string file, std::string attempted);

  // Complains about the first key that is not among `keys` and names the nearest of them.
  void allowOnly(std::span<const std::string> keys);

  [[nodiscard]] std::string text(std::string_view key);  // required, not empty
  [[nodiscard]] std::optional<std::string> optionalText(std::string_view key);
  [[nodiscard]] std::vector<std::string> texts(std::string_view key);  // required, a list that is not empty
  [[nodiscard]] std::vector<std::string> optionalTexts(std::string_view key);  // empty when absent
  [[nodiscard]] std::optional<double> number(std::string_view key, double low, double high);
  [[nodiscard]] std::optional<int> integer(std::string_view key, int low, int high);
  [[nodiscard]] bool flag(std::string_view key);  // false when absent

  // Complains about the value of `key`, or about the table when the key is absent.
  void complain(std::string_view key, std::string problem, std::string remedy = {});
  // Complains when `word`, the value of `key`, is not among `known`.
  void requireKnown(std::string_view key, std::string_view word, std::string_view what,
                    std::span<const std::string> known);

  // Complains unless `word`, the value of `key`, is made of a-z, 0-9, '.', '_' and '-'.
  void requirePlainId(std::string_view key, std::string_view word);

  [[nodiscard]] bool ok() const { return !error_; }
  [[nodiscard]] Expected<void> result() const;
  [[nodiscard]] std::string whereIs(std::string_view key) const;

 private:
  void complainAt(TomlPlace place, std::string problem, std::string remedy);
  // The value of `key` if it has the wanted kind; complains when it has another.
  [[nodiscard]] const TomlValue* value(std::string_view key, TomlValue::Kind wanted);
  void complainMissing(std::string_view key);

  const TomlValue& table_;
  std::string label_;
  std::string file_;
  std::string attempted_;
  std::optional<Error> error_;
};

// "; did you mean 'metric'?" or "; known are ..." for a word that is none of `known`.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace ssrkit
