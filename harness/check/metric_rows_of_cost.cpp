// Metrics of cost, and properties: what an answer tells by itself.
#include <utility>

#include "check/metric_rows.h"

namespace ssrkit {

namespace {

using enum TruthKind;

const std::vector<TruthKind> kByItself = {kNone};
const std::vector<std::string> kTrace = {"trace"};

}  // namespace

std::vector<MetricRow> metricsOfCost() {
  using M = Metric;
  const std::string lookups = "lookups per ray";
  const std::string cpu_time = "ratio of CPU time";
  return {
      {.metric = M::kMeanLookups,
       .name = "mean_lookups",
       .unit = lookups,
       .truths = kByItself,
       .measure = measureLookups},
      {.metric = M::kP95Lookups,
       .name = "p95_lookups",
       .unit = lookups,
       .truths = kByItself,
       .measure = measureLookups},
      {.metric = M::kMaxLookups,
       .name = "max_lookups",
       .unit = lookups,
       .truths = kByItself,
       .measure = measureLookups},
      {.metric = M::kLookupRatio,
       .name = "lookup_ratio",
       .unit = "times fewer lookups",
       .truths = {kStage, kCase},
       .measure = measureLookupRatio,
       .shows_figure = true},
      {.metric = M::kLookupsAdded,
       .name = "lookups_added",
       .unit = lookups,
       .truths = {kSize},
       .measure = measureLookupsAdded,
       .shows_figure = true},
      {.metric = M::kP95LookupRatio,
       .name = "p95_lookup_ratio",
       .unit = "ratio of lookups",
       .truths = {kCase, kStage},
       .measure = measureP95LookupRatio},
      {.metric = M::kMissLookupRatio,
       .name = "miss_lookup_ratio",
       .unit = "ratio of lookups",
       .truths = kByItself,
       .measure = bySubject<measureMissLookupRatio>},
      {.metric = M::kCpuRatio,
       .name = "cpu_ratio",
       .unit = cpu_time,
       .truths = {kStage, kCase, kCross},
       .measure = measureCpuRatio,
       .keys = {"passes", "over", "margin"},
       .default_passes = kTrace,
       .timed = true,
       .shows_figure = true},
      {.metric = M::kPixelCpuRatio,
       .name = "pixel_cpu_ratio",
       .unit = "ratio of CPU time per pixel",
       .truths = {kSize},
       .measure = measureCpuRatio,
       .keys = {"passes", "over", "margin"},
       .default_passes = kTrace,
       .timed = true},
      {.metric = M::kWallRatio,
       .name = "wall_ratio",
       .unit = "ratio of wall time",
       .truths = {kCross, kStage, kCase},
       .measure = measureCpuRatio,
       .keys = {"passes", "over", "margin"},
       .default_passes = kTrace,
       .timed = true},
      {.metric = M::kRooflineMultiple,
       .name = "roofline_multiple",
       .unit = "times the machine's limit",
       .truths = kByItself,
       .measure = measureRooflineMultiple,
       .keys = {"margin"},
       .timed = true},
      {.metric = M::kPassCpuShare,
       .name = "pass_cpu_share",
       .unit = cpu_time,
       .truths = kByItself,
       .measure = measureCpuRatio,
       .keys = {"passes", "over", "margin"},
       .needed_keys = {"passes", "over"},
       .timed = true,
       .shows_figure = true},
      {.metric = M::kPassCpuLead,
       .name = "pass_cpu_lead",
       .unit = cpu_time,
       .truths = kByItself,
       .measure = measureCpuRatio,
       .keys = {"passes", "margin"},
       .needed_keys = {"passes"},
       .timed = true},
      {.metric = M::kResampledShare,
       .name = "resampled_share",
       .unit = "share of samples",
       .truths = kByItself,
       .measure = measureSampling,
       .needs_oracle = true},
      {.metric = M::kSkippedShare,
       .name = "skipped_share",
       .unit = "share of texels",
       .truths = kByItself,
       .measure = measureSampling,
       .needs_oracle = true},
  };
}

std::vector<MetricRow> metricsOfProperties() {
  using M = Metric;
  const auto property = [](Metric metric, std::string metric_name) {
    return MetricRow{.metric = metric,
                     .name = std::move(metric_name),
                     .unit = "pixels",
                     .truths = kByItself,
                     .measure = measureProperty,
                     .zero_by_default = true};
  };
  MetricRow finite = property(M::kFinite, "finite");
  finite.on_image = true;
  MetricRow monotone = property(M::kBudgetMonotone, "budget_monotone");
  monotone.over_cases = true;
  monotone.measure = measureBudgetMonotone;
  return {{.metric = M::kConvergence,
           .name = "convergence",
           .unit = "projected steps",
           .truths = {kOracle},
           .measure = measureConvergence,
           .keys = {"percentile"},
           .over_cases = true,
           .needs_oracle = true,
           .shows_figure = true},
          monotone,
          finite,
          property(M::kNoSelfHit, "no_self_hit"),
          property(M::kHitPointInTexel, "hit_point_in_texel"),
          property(M::kInsideImage, "inside_image"),
          property(M::kLookupsWithinBudget, "lookups_within_budget"),
          property(M::kClassConsistent, "class_consistent")};
}

}  // namespace ssrkit
