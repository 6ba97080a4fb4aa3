#include "report/checks_csv.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <vector>

#include "report/plain_utf8.h"

namespace ssrkit {

namespace {

std::string field(std::string_view raw) {
  const std::string text = plainUtf8(raw);
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char byte : text) {
    quoted += byte == '"' ? "\"\"" : std::string(1, byte);
  }
  return quoted + "\"";
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string csvLine(const std::vector<std::string>& fields) {
  return fmt::format("{}\r\n", fmt::join(fields, ","));
}

std::string checkLine(const CheckResult& check) {
  return csvLine({field(check.id), field(check.scene), field(check.device), field(check.stage),
                  std::to_string(check.size.width), std::to_string(check.size.height), field(check.case_name),
                  name(check.outcome), field(check.metric), number(check.value), number(check.min),
                  number(check.max), field(check.unit), std::to_string(check.compared), field(check.message),
                  field(check.repro)});
}

}  // namespace

std::string checksCsv(const RunReport& report) {
  std::string text = csvLine({"id", "scene", "device", "stage", "width", "height", "case", "outcome",
                              "metric", "value", "min", "max", "unit", "compared", "message", "repro"});
  for (const CheckResult& check : report.checks) {
    text += checkLine(check);
  }
  return text;
}

}  // namespace ssrkit
