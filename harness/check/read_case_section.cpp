#include "check/read_case_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/field_reader.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

namespace {

std::string parameterValueText(const TomlValue& value) {
  switch (value.kind) {
    case TomlValue::Kind::kText:
      return value.text;
    case TomlValue::Kind::kInteger:
      return fmt::format("{}", value.integer);
    default:
      return fmt::format("{}", value.number);
  }
}

}  // namespace

Expected<TestCase> readCaseSection(const TomlValue& table, const TestFile& test, const KnownNames& known,
                                   const std::string& attempted) {
  FieldReader fields(table, "[[case]]", test.file, attempted);
  std::vector<std::string> keys = {"name", "technique", "variant"};
  keys.insert(keys.end(), parameterNames().begin(), parameterNames().end());
  fields.allowOnly(keys);
  TestCase test_case;
  test_case.name = fields.text("name");
  fields.requirePlainId("name", test_case.name);
  if (std::ranges::find(test.cases, test_case.name, &TestCase::name) != test.cases.end()) {
    fields.complain("name", fmt::format("two cases are named '{}'", test_case.name), "rename one of them");
  }
  test_case.technique = fields.optionalText("technique").value_or("");
  if (!test_case.technique.empty() && !known.techniques.empty()) {
    fields.requireKnown("technique", test_case.technique, "technique", known.techniques);
  }
  test_case.variant = fields.optionalText("variant").value_or("");
  if (!test_case.variant.empty() && !known.variants.empty()) {
    fields.requireKnown("variant", test_case.variant, "variant", known.variants);
  }
  TraceParameters scratch;
  for (const TomlEntry& entry : table.entries) {
    if (!fields.ok()) {
      break;
    }
    if (entry.key == "name" || entry.key == "technique" || entry.key == "variant") {
      continue;
    }
    using enum TomlValue::Kind;
    if (entry.value.kind != kText && entry.value.kind != kInteger && entry.value.kind != kFloat) {
      fields.complain(entry.key,
                      fmt::format("the parameter '{}' cannot be {}", entry.key, name(entry.value.kind)));
      break;
    }
    const std::string value = parameterValueText(entry.value);
    if (auto set = setParameter(scratch, entry.key, value, fields.whereIs(entry.key)); !set) {
      return tl::make_unexpected(set.error());
    }
    test_case.parameters.emplace_back(entry.key, value);
  }
  if (!fields.ok()) {
    return tl::make_unexpected(fields.result().error());
  }
  if (isThicknessRelativeAlone(test_case.parameters)) {
    test_case.parameters.emplace_back("thickness_m", "0");
  }
  return test_case;
}

}  // namespace ssrkit
