#include "check/read_metric_keys.h"

#include <optional>
#include <string>
#include <vector>

namespace ssrkit {

namespace {

void readTrueClasses(FieldReader& fields, const MetricRow& metric_row, Expectation& expectation) {
  static const std::vector<std::string> class_names = {"VISIBLE",  "UNSAMPLED",      "OCCLUDED",
                                                       "BACKFACE", "OFFSCREEN_TRUE", "SKY"};
  const bool is_required = metric_row.metric == Metric::kTrueClassShare;
  for (const std::string& word :
       is_required ? fields.texts("true_classes") : fields.optionalTexts("true_classes")) {
    fields.requireKnown("true_classes", word, "true class", class_names);
    expectation.true_classes.push_back(trueClassFromName(word).value_or(TrueClass::kNone));
  }
  if (metric_row.metric == Metric::kTrueVerdictShare) {
    static const std::vector<std::string> verdict_names = {"TRUE_HIT", "FALSE_HIT", "MISSED_HIT",
                                                           "TRUE_MISS"};
    for (const std::string& word : fields.texts("verdicts")) {
      fields.requireKnown("verdicts", word, "verdict against the geometry", verdict_names);
      expectation.geometry_verdicts.push_back(geometryVerdictFromName(word).value_or(GeometryVerdict::kNone));
    }
  }
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
  if (takesKey(metric_row, "true_classes")) {
    readTrueClasses(fields, metric_row, expectation);
  } else if (takesKey(metric_row, "verdicts")) {
    static const std::vector<std::string> verdict_names = {"SAME",       "NEAR", "WRONG",    "FALSE_HIT",
                                                           "MISSED_HIT", "LEAK", "AMBIGUOUS"};
    for (const std::string& word : fields.texts("verdicts")) {
      fields.requireKnown("verdicts", word, "verdict", verdict_names);
      expectation.verdicts.push_back(verdictFromName(word).value_or(Verdict::kNone));
    }
  }
  expectation.passes = fields.optionalTexts("passes");
  expectation.over = fields.optionalTexts("over");
  const bool is_pass_ratio = metric_row.metric == Metric::kCpuRatio ||
                             metric_row.metric == Metric::kPixelCpuRatio ||
                             metric_row.metric == Metric::kWallRatio;
  if (is_pass_ratio && expectation.passes.empty()) {
    expectation.passes = {"trace"};
  }
  if (metric_row.timed && test.rounds == 0) {
    fields.complain("metric", fmt::format("the metric '{}' needs timings", metric_row.name),
                    "add rounds = 15 to [test]");
  }
  if (metric_row.metric == Metric::kPassCpuShare || metric_row.metric == Metric::kPassCpuLead) {
    expectation.passes = fields.texts("passes");
  }
  if (metric_row.metric == Metric::kPassCpuShare) {
    expectation.over = fields.texts("over");
  }
}

}  // namespace ssrkit
