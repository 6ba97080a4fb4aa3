#include "check/read_baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/atomic_file.h"
#include "base/text.h"
#include "check/field_reader.h"

namespace ssrkit {

namespace {

constexpr const char* kSection = "expected_failure";
const std::vector<std::string> kBaselineFileKeys = {kSection};
const std::vector<std::string> kExpectedFailureKeys = {
    "id", "device", "scene", "stage", "case", "size", "driver", "outcome", "reason", "expires", "bug"};

std::optional<unsigned> digits(std::string_view text) {
  unsigned value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

// "2026-01-31"
std::optional<std::chrono::sys_days> parseDate(std::string_view text) {
  const std::vector<std::string> parts = split(text, '-');
  if (parts.size() != 3 || parts[0].size() != 4 || parts[1].size() != 2 || parts[2].size() != 2) {
    return std::nullopt;
  }
  const auto year = digits(parts[0]);
  const auto month = digits(parts[1]);
  const auto day = digits(parts[2]);
  if (!year || !month || !day) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(*month), std::chrono::day(*day)};
  return date.ok() ? std::optional<std::chrono::sys_days>(date) : std::nullopt;
}

// Only what fails can be expected to fail.
std::vector<Outcome> readOutcomes(FieldReader& fields) {
  static const std::vector<std::string> expectable = {"fail",    "error",   "crash",
                                                      "timeout", "limiter", "missing"};
  std::vector<Outcome> outcomes;
  for (const std::string& word : fields.texts("outcome")) {
    fields.requireKnown("outcome", word, "outcome that can be expected", expectable);
    outcomes.push_back(outcomeFromName(word).value_or(Outcome::kFail));
  }
  return outcomes;
}

Expected<KnownFailure> readEntry(const TomlValue& table, const std::string& file, const KnownNames& known,
                                 const std::string& attempted) {
  FieldReader fields(table, "[[expected_failure]]", file, attempted);
  fields.allowOnly(kExpectedFailureKeys);
  KnownFailure entry;
  entry.id = fields.text("id");
  entry.device = fields.text("device");
  const bool is_pattern = entry.device.find_first_of("*?[") != std::string::npos;
  if (!is_pattern && !known.devices.empty()) {
    fields.requireKnown("device", entry.device, "device", known.devices);
  }
  entry.scene = fields.optionalText("scene").value_or(entry.scene);
  entry.stage = fields.optionalText("stage").value_or(entry.stage);
  entry.case_name = fields.optionalText("case").value_or(entry.case_name);
  entry.size = fields.optionalText("size").value_or(entry.size);
  entry.driver = fields.optionalText("driver").value_or("");
  entry.outcomes = readOutcomes(fields);
  entry.reason = fields.text("reason");
  const std::string expires = fields.text("expires");
  if (const auto date = parseDate(expires)) {
    entry.expires = *date;
  } else {
    fields.complain("expires", fmt::format("'{}' is no date", expires), "write it as \"2026-12-31\"");
  }
  entry.bug = fields.text("bug");
  entry.where = placeText(file, table.place);
  return fields.ok() ? Expected<KnownFailure>(std::move(entry))
                     : tl::make_unexpected(fields.result().error());
}

}  // namespace

Expected<std::vector<KnownFailure>> readBaseline(std::string_view content, const std::string& file,
                                                 const KnownNames& known) {
  const std::string attempted = fmt::format("read the baseline '{}'", file);
  const Expected<TomlValue> document = parseToml(content, file, attempted);
  if (!document) {
    return tl::make_unexpected(document.error());
  }
  FieldReader top(*document, "the file", file, attempted);
  top.allowOnly(kBaselineFileKeys);
  const TomlEntry* const sections = document->find(kSection);
  if (sections != nullptr && sections->value.kind != TomlValue::Kind::kArray) {
    top.complain(kSection, fmt::format("'{}' must be sections", kSection),
                 "write it as [[expected_failure]]");
  }
  if (!top.ok()) {
    return tl::make_unexpected(top.result().error());
  }
  std::vector<KnownFailure> entries;
  for (const TomlValue& table : sections == nullptr ? std::vector<TomlValue>{} : sections->value.elements) {
    auto entry = table.kind == TomlValue::Kind::kTable
                     ? readEntry(table, file, known, attempted)
                     : inputError(attempted, "an entry is no section", placeText(file, table.place),
                                  "write it as [[expected_failure]]");
    if (!entry) {
      return tl::make_unexpected(entry.error());
    }
    entries.push_back(std::move(*entry));
  }
  return entries;
}

Expected<std::vector<KnownFailure>> loadBaseline(const std::filesystem::path& file, const KnownNames& known) {
  const Expected<std::string> content = readFile(file);
  return content ? readBaseline(*content, file.string(), known) : tl::make_unexpected(content.error());
}

}  // namespace ssrkit
