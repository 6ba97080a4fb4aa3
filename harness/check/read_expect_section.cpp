#include "check/read_expect_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/size.h"
#include "base/text.h"
#include "check/field_reader.h"
#include "check/read_metric_keys.h"

namespace ssrkit {

namespace {

struct TruthWord {
  TruthKind kind;
  std::string word;  // ends in ':' when a name follows
};

const std::vector<TruthWord>& truthWords() {
  static const std::vector<TruthWord> words = {
      {TruthKind::kNone, "none"},         {TruthKind::kOracle, "oracle"},
      {TruthKind::kGeometry, "geometry"}, {TruthKind::kClosedForm, "closed-form"},
      {TruthKind::kRendered, "rendered"}, {TruthKind::kCross, "cross:"},
      {TruthKind::kStage, "stage:"},      {TruthKind::kCase, "case:"},
      {TruthKind::kSize, "size:"},        {TruthKind::kGolden, "golden"},
  };
  return words;
}

const std::string& wordOf(TruthKind kind) {
  return std::ranges::find(truthWords(), kind, &TruthWord::kind)->word;
}

std::optional<Truth> parseTruth(std::string_view text) {
  for (const TruthWord& entry : truthWords()) {
    if (!entry.word.ends_with(':') && text == entry.word) {
      return Truth{entry.kind, ""};
    }
    if (entry.word.ends_with(':') && text.starts_with(entry.word) && text.size() > entry.word.size()) {
      return Truth{entry.kind, std::string(text.substr(entry.word.size()))};
    }
  }
  return std::nullopt;
}

std::vector<std::string> caseNames(const TestFile& test) {
  std::vector<std::string> names;
  for (const TestCase& test_case : test.cases) {
    names.push_back(test_case.name);
  }
  return names;
}

std::vector<std::string> keysOf(const MetricRow& metric_row) {
  std::vector<std::string> keys = {"name", "metric", "buffer", "stages",      "cases",   "sizes", "truth",
                                   "max",  "min",    "unit",   "allow_empty", "devices", "pair"};
  keys.insert(keys.end(), metric_row.keys.begin(), metric_row.keys.end());
  return keys;
}

void readTruth(FieldReader& fields, const MetricRow& metric_row, const TestFile& test,
               const KnownNames& known, Expectation& expectation) {
  std::vector<std::string> allowed;
  for (const TruthKind kind : metric_row.truths) {
    allowed.push_back(wordOf(kind) + (wordOf(kind).ends_with(':') ? "NAME" : ""));
  }
  const std::optional<std::string> text = fields.optionalText("truth");
  const bool default_needs_name = wordOf(metric_row.truths.front()).ends_with(':');
  if (!text && default_needs_name) {
    fields.complain("truth", fmt::format("the metric '{}' needs a truth", metric_row.name),
                    fmt::format("add truth = \"...\", one of {}", joinNames(allowed)));
    return;
  }
  const std::optional<Truth> truth = text ? parseTruth(*text) : Truth{metric_row.truths.front(), ""};
  if (!truth || std::ranges::find(metric_row.truths, truth->kind) == metric_row.truths.end()) {
    fields.complain("truth",
                    fmt::format("the metric '{}' cannot be held against '{}'", metric_row.name, *text),
                    fmt::format("known are {}", joinNames(allowed)));
    return;
  }
  expectation.truth = *truth;
  if (truth->kind == TruthKind::kStage && !known.stages.empty()) {
    fields.requireKnown("truth", truth->name, "stage", known.stages);
  } else if (truth->kind == TruthKind::kCross && !known.devices.empty()) {
    fields.requireKnown("truth", truth->name, "device", known.devices);
  } else if (truth->kind == TruthKind::kCase) {
    fields.requireKnown("truth", truth->name, "case", caseNames(test));
  } else if (truth->kind == TruthKind::kSize && !parseSize(truth->name)) {
    fields.complain("truth", fmt::format("'{}' is no size", truth->name), "write it as \"size:1280x720\"");
  } else if (truth->kind == TruthKind::kGeometry && !metric_row.on_record &&
             expectation.buffer != "dist_view") {
    fields.complain("buffer",
                    fmt::format("the truth 'geometry' does not know the buffer '{}'", expectation.buffer),
                    "of the images it knows dist_view alone");
  }
}

// Which devices are asked: those named, those whose pair with the truth's device is of the class named, or
// all.
void readDevices(FieldReader& fields, const TestFile& test, const KnownNames& known,
                 Expectation& expectation) {
  const std::vector<std::string> named = fields.optionalTexts("devices");
  for (const std::string& device : named) {
    const std::vector<std::string>& names = test.devices.empty() ? known.devices : test.devices;
    if (!names.empty()) {
      fields.requireKnown("devices", device, "device", names);
    }
  }
  if (!named.empty()) {
    expectation.devices = named;
  }
  const std::optional<std::string> word = fields.optionalText("pair");
  if (!word) {
    return;
  }
  if (*word != "P" && *word != "R" && *word != "X") {
    fields.complain("pair", fmt::format("'{}' is no class of pairs", *word),
                    "write \"P\" (same pipeline), \"R\" (same rasteriser) or \"X\" (another one)");
  } else if (expectation.truth.kind != TruthKind::kCross || !named.empty()) {
    fields.complain("pair", "a pair is a device and the one that the truth names",
                    "add truth = \"cross:DEVICE\", and leave devices out");
  } else if (known.tolerance_class) {
    expectation.devices.emplace();
    std::ranges::copy_if(known.devices, std::back_inserter(*expectation.devices),
                         [&](const std::string& device) {
                           return known.tolerance_class(device, expectation.truth.name) == *word;
                         });
  }
}

// Stages, cases and sizes that the expectation is asked of: subsets of the test's.
void readScope(FieldReader& fields, const MetricRow& metric_row, const TestFile& test,
               Expectation& expectation) {
  expectation.buffer = fields.optionalText("buffer").value_or("hit");
  const bool is_record = expectation.buffer == "hit";
  if (is_record ? !metric_row.on_record : !metric_row.on_image) {
    fields.complain(
        "buffer",
        fmt::format("the metric '{}' cannot judge the buffer '{}'", metric_row.name, expectation.buffer),
        is_record ? "name an image, as in buffer = \"dist_view\"" : "leave the key out or write \"hit\"");
  }
  expectation.stages = fields.optionalTexts("stages");
  for (const std::string& stage : expectation.stages) {
    fields.requireKnown("stages", stage, "stage", test.stages);
  }
  if (expectation.stages.empty() && is_record) {
    expectation.stages = test.stages;
  }
  if (expectation.stages.empty() && is_record) {
    fields.complain("stages", "the buffer 'hit' belongs to a stage, and the test runs none",
                    "add stages = [...] to [test]");
  }
  expectation.cases = fields.optionalTexts("cases");
  for (const std::string& case_name : expectation.cases) {
    fields.requireKnown("cases", case_name, "case", caseNames(test));
  }
  if (metric_row.over_cases && expectation.cases.size() < 2) {
    fields.complain("cases",
                    fmt::format("the metric '{}' compares at least two cases in order", metric_row.name),
                    "add cases = [\"first\", \"second\"]");
  } else if (expectation.cases.empty()) {
    expectation.cases = caseNames(test);
  }
  for (const std::string& text : fields.optionalTexts("sizes")) {
    const std::optional<Size> size = parseSize(text);
    if (!size || std::ranges::find(test.sizes, *size) == test.sizes.end()) {
      fields.complain("sizes", fmt::format("'{}' is not among the test's sizes", text));
      return;
    }
    expectation.sizes.push_back(*size);
  }
}

void readBounds(FieldReader& fields, const MetricRow& metric_row, const ReadRules& rules,
                Expectation& expectation) {
  expectation.max = fields.number("max", -kUnlimited, kUnlimited);
  expectation.min = fields.number("min", -kUnlimited, kUnlimited);
  if (!expectation.max && !expectation.min && rules.needs_bounds) {
    if (metric_row.zero_by_default) {
      expectation.max = 0.0;
    } else {
      fields.complain("metric", fmt::format("the metric '{}' has no bound to hold", metric_row.name),
                      "add max = ... or min = ...");
    }
  }
  if (expectation.max && expectation.min && *expectation.min > *expectation.max) {
    fields.complain("min", "'min' is larger than 'max'", "exchange them");
  }
  const std::optional<std::string> unit = fields.optionalText("unit");
  if (unit && *unit != metric_row.unit) {
    fields.complain("unit", fmt::format("the metric '{}' is in '{}', not in '{}'", metric_row.name,
                                        metric_row.unit, *unit));
  }
}

}  // namespace

std::string truthText(const Truth& truth) {
  return wordOf(truth.kind) + truth.name;
}

Expected<Expectation> readExpectSection(const TomlValue& table, const TestFile& test, const KnownNames& known,
                                        const ReadRules& rules, const std::string& attempted) {
  FieldReader fields(table, "[[expect]]", test.file, attempted);
  Expectation expectation;
  const std::string metric = fields.text("metric");
  const MetricRow* metric_row = findMetric(metric);
  if (metric_row == nullptr) {
    fields.requireKnown("metric", metric, "metric", metricNames());
    return tl::make_unexpected(fields.result().error());
  }
  std::vector<std::string> keys = keysOf(*metric_row);
  keys.insert(keys.end(), rules.expect_keys.begin(), rules.expect_keys.end());
  fields.allowOnly(keys);
  expectation.metric = metric_row->metric;
  expectation.name = fields.optionalText("name").value_or(metric);
  expectation.where = placeText(test.file, table.place);
  expectation.allow_empty = fields.flag("allow_empty");
  readScope(fields, *metric_row, test, expectation);
  readTruth(fields, *metric_row, test, known, expectation);
  readDevices(fields, test, known, expectation);
  readBounds(fields, *metric_row, rules, expectation);
  readMetricKeys(fields, *metric_row, test, expectation);
  if (!fields.ok()) {
    return tl::make_unexpected(fields.result().error());
  }
  return expectation;
}

}  // namespace ssrkit
