#include "check/metric_table.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace ssrkit {

namespace {

using enum TruthKind;

const std::vector<TruthKind> kByItself = {kNone};
const std::vector<TruthKind> kOtherAnswers = {kCross, kStage, kRendered, kCase, kGolden};

std::vector<MetricRow> rowsAgainstTruth() {
  using M = Metric;
  return {
      {.metric = M::kDifferentRays,
       .name = "different_rays",
       .unit = "rays",
       .truths = {kOracle, kStage, kCross, kCase, kRendered, kGolden},
       .zero_by_default = true},
      {.metric = M::kAmbiguousShare, .name = "ambiguous_share", .unit = "share", .truths = {kOracle}},
      {.metric = M::kVerdicts,
       .name = "verdict_count",
       .unit = "rays",
       .truths = {kOracle},
       .keys = {"verdicts"},
       .zero_by_default = true},
      {.metric = M::kVerdictShare,
       .name = "verdict_share",
       .unit = "share",
       .truths = {kOracle},
       .keys = {"verdicts"}},
      {.metric = M::kVerdictGain,
       .name = "verdict_gain",
       .unit = "share",
       .truths = {kStage, kCase},
       .keys = {"verdicts"},
       .needs_oracle = true},
      {.metric = M::kHitPositionPx,
       .name = "hit_position_px",
       .unit = "px",
       .truths = {kOracle, kStage, kCross, kRendered, kCase, kGeometry, kGolden},
       .keys = {"percentile"}},
      {.metric = M::kHitJumpPx,
       .name = "hit_jump_px",
       .unit = "px",
       .truths = {kOracle, kStage, kCase},
       .keys = {"percentile"}},
      {.metric = M::kFoundShare, .name = "found_share", .unit = "share of hits", .truths = {kOracle}},
      {.metric = M::kClosedForm,
       .name = "closed_form",
       .unit = "pixels",
       .truths = {kClosedForm},
       .zero_by_default = true},
      {.metric = M::kClosedFormLookups,
       .name = "closed_form_lookups",
       .unit = "pixels",
       .truths = {kClosedForm},
       .zero_by_default = true},
      {.metric = M::kIdentical,
       .name = "identical",
       .unit = "pixels",
       .truths = kOtherAnswers,
       .keys = {"ignore"},
       .on_image = true,
       .zero_by_default = true},
      {.metric = M::kCoverageFlips,
       .name = "coverage_flips",
       .unit = "pixels",
       .truths = {kCross, kRendered, kGeometry, kGolden},
       .on_record = false,
       .on_image = true,
       .zero_by_default = true},
      {.metric = M::kRelativeError,
       .name = "relative_error",
       .unit = "ratio",
       .truths = {kCross, kStage, kRendered, kCase, kGeometry, kGolden},
       .keys = {"percentile"},
       .on_record = false,
       .on_image = true},
      {.metric = M::kAbsoluteError,
       .name = "absolute_error",
       .unit = "units of the buffer",
       .truths = kOtherAnswers,
       .keys = {"percentile"},
       .on_record = false,
       .on_image = true},
      {.metric = M::kFlip,
       .name = "flip",
       .unit = "FLIP",
       .truths = kOtherAnswers,
       .keys = {"percentile"},
       .on_record = false,
       .on_image = true},
      {.metric = M::kMaskFlipsPerMillion,
       .name = "mask_flips_per_million",
       .unit = "flips per million pixels",
       .truths = kOtherAnswers},
  };
}

std::vector<MetricRow> rowsAgainstGeometry() {
  using M = Metric;
  return {{.metric = M::kTrueClassShare,
           .name = "true_class_share",
           .unit = "share",
           .truths = {kGeometry},
           .keys = {"true_classes"}},
          {.metric = M::kTrueVerdictShare,
           .name = "true_verdict_share",
           .unit = "share",
           .truths = {kGeometry},
           .keys = {"verdicts", "true_classes"}},
          {.metric = M::kHitDistanceError,
           .name = "hit_distance_error",
           .unit = "ratio",
           .truths = {kGeometry},
           .keys = {"percentile"}}};
}

std::vector<MetricRow> rowsOfCost() {
  using M = Metric;
  const std::string lookups = "lookups per ray";
  const std::string cpu_time = "ratio of CPU time";
  return {
      {.metric = M::kMeanLookups, .name = "mean_lookups", .unit = lookups, .truths = kByItself},
      {.metric = M::kP95Lookups, .name = "p95_lookups", .unit = lookups, .truths = kByItself},
      {.metric = M::kMaxLookups, .name = "max_lookups", .unit = lookups, .truths = kByItself},
      {.metric = M::kLookupRatio,
       .name = "lookup_ratio",
       .unit = "times fewer lookups",
       .truths = {kStage, kCase}},
      {.metric = M::kLookupsAdded, .name = "lookups_added", .unit = lookups, .truths = {kSize}},
      {.metric = M::kP95LookupRatio,
       .name = "p95_lookup_ratio",
       .unit = "ratio of lookups",
       .truths = {kCase, kStage}},
      {.metric = M::kMissLookupRatio,
       .name = "miss_lookup_ratio",
       .unit = "ratio of lookups",
       .truths = kByItself},
      {.metric = M::kCpuRatio,
       .name = "cpu_ratio",
       .unit = cpu_time,
       .truths = {kStage, kCase, kCross},
       .keys = {"passes", "over", "margin"},
       .timed = true},
      {.metric = M::kPixelCpuRatio,
       .name = "pixel_cpu_ratio",
       .unit = "ratio of CPU time per pixel",
       .truths = {kSize},
       .keys = {"passes", "over", "margin"},
       .timed = true},
      {.metric = M::kWallRatio,
       .name = "wall_ratio",
       .unit = "ratio of wall time",
       .truths = {kCross, kStage, kCase},
       .keys = {"passes", "over", "margin"},
       .timed = true},
      {.metric = M::kRooflineMultiple,
       .name = "roofline_multiple",
       .unit = "times the machine's limit",
       .truths = kByItself,
       .keys = {"margin"},
       .timed = true},
      {.metric = M::kPassCpuShare,
       .name = "pass_cpu_share",
       .unit = cpu_time,
       .truths = kByItself,
       .keys = {"passes", "over", "margin"},
       .timed = true},
      {.metric = M::kPassCpuLead,
       .name = "pass_cpu_lead",
       .unit = cpu_time,
       .truths = kByItself,
       .keys = {"passes", "margin"},
       .timed = true},
      {.metric = M::kResampledShare,
       .name = "resampled_share",
       .unit = "share of samples",
       .truths = kByItself,
       .needs_oracle = true},
      {.metric = M::kSkippedShare,
       .name = "skipped_share",
       .unit = "share of texels",
       .truths = kByItself,
       .needs_oracle = true},
  };
}

std::vector<MetricRow> rowsOfProperties() {
  using M = Metric;
  const auto property = [](Metric metric, std::string metric_name) {
    return MetricRow{.metric = metric,
                     .name = std::move(metric_name),
                     .unit = "pixels",
                     .truths = kByItself,
                     .zero_by_default = true};
  };
  MetricRow finite = property(M::kFinite, "finite");
  finite.on_image = true;
  MetricRow monotone = property(M::kBudgetMonotone, "budget_monotone");
  monotone.over_cases = true;
  return {{.metric = M::kConvergence,
           .name = "convergence",
           .unit = "projected steps",
           .truths = {kOracle},
           .keys = {"percentile"},
           .over_cases = true,
           .needs_oracle = true},
          monotone,
          finite,
          property(M::kNoSelfHit, "no_self_hit"),
          property(M::kHitPointInTexel, "hit_point_in_texel"),
          property(M::kInsideImage, "inside_image"),
          property(M::kLookupsWithinBudget, "lookups_within_budget"),
          property(M::kClassConsistent, "class_consistent")};
}

std::vector<MetricRow> makeRows() {
  std::vector<MetricRow> rows = rowsAgainstTruth();
  for (const auto& more : {rowsAgainstGeometry(), rowsOfCost(), rowsOfProperties()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace

std::span<const MetricRow> metricRows() {
  static const std::vector<MetricRow> rows = makeRows();
  return rows;
}

const MetricRow& row(Metric metric) {
  const MetricRow& found = metricRows()[static_cast<std::size_t>(metric)];
  SSRKIT_CHECK(found.metric == metric);
  return found;
}

const MetricRow* findMetric(std::string_view metric_name) {
  const auto found = std::ranges::find(metricRows(), metric_name, &MetricRow::name);
  return found == metricRows().end() ? nullptr : &*found;
}

std::span<const std::string> metricNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> collected;
    for (const MetricRow& metric_row : metricRows()) {
      collected.push_back(metric_row.name);
    }
    return collected;
  }();
  return names;
}

bool takesKey(const MetricRow& row, std::string_view key) {
  return std::ranges::find(row.keys, key) != row.keys.end();
}

}  // namespace ssrkit
