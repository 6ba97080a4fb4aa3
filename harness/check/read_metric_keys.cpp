#include "check/read_metric_keys.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ssrkit {

namespace {

// The names of an enumeration's values but the first, which stands for nothing that could be named.
template <class Enum, int count>
const std::vector<std::string>& namesOf() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (int i = 1; i < count; ++i) {
      list.emplace_back(name(static_cast<Enum>(i)));
    }
    return list;
  }();
  return names;
}

// The values that the words of `key` name; complains of a word that names none.
template <int count, class Enum>
std::vector<Enum> readNames(FieldReader& fields, std::string_view key, std::string_view what,
                            const std::vector<std::string>& words,
                            std::optional<Enum> (*from_name)(std::string_view)) {
  std::vector<Enum> values;
  for (const std::string& word : words) {
    fields.requireKnown(key, word, what, namesOf<Enum, count>());
    values.push_back(from_name(word).value_or(Enum{}));
  }
  return values;
}

}  // namespace

void readMetricKeys(FieldReader& fields, const MetricRow& metric_row, const TestFile& test,
                    Expectation& expectation) {
  const std::optional<double> percentile = fields.number("percentile", 0.0, 100.0);
  expectation.percentile = percentile.value_or(expectation.percentile);
  expectation.has_percentile = percentile.has_value();
  expectation.margin = fields.number("margin", 0.0, 10.0).value_or(expectation.margin);
  static const std::vector<std::string> record_fields = {"texel", "px", "t_m", "class", "lookups", "steps"};
  expectation.ignore = fields.optionalTexts("ignore");
  for (const std::string& field : expectation.ignore) {
    fields.requireKnown("ignore", field, "field of the record", record_fields);
  }
  const auto words = [&](std::string_view key) {
    return needsKey(metric_row, key) ? fields.texts(key) : fields.optionalTexts(key);
  };
  const bool against_geometry = takesKey(metric_row, "true_classes");
  expectation.true_classes = readNames<kTrueClassCount>(fields, "true_classes", "true class",
                                                        words("true_classes"), trueClassFromName);
  if (takesKey(metric_row, "verdicts") && against_geometry) {
    expectation.geometry_verdicts = readNames<kGeometryVerdictCount>(
        fields, "verdicts", "verdict against the geometry", words("verdicts"), geometryVerdictFromName);
  } else if (takesKey(metric_row, "verdicts")) {
    expectation.verdicts =
        readNames<kVerdictCount>(fields, "verdicts", "verdict", words("verdicts"), verdictFromName);
  }
  expectation.passes = words("passes");
  if (expectation.passes.empty()) {
    expectation.passes = metric_row.default_passes;
  }
  expectation.over = words("over");
  if (metric_row.timed && test.rounds == 0) {
    fields.complain("metric", fmt::format("the metric '{}' needs timings", metric_row.name),
                    "add rounds = 15 to [test]");
  }
}

}  // namespace ssrkit
