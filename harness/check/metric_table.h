// Every metric as a row of data: its name in files, its unit, what measures it, what it may be held against
// and which keys it takes. A metric is its name in the enumeration, its row and its function.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ssrkit {

enum class Metric : std::uint8_t {
  kDifferentRays,
  kAmbiguousShare,
  kVerdicts,
  kVerdictShare,
  kVerdictGain,
  kHitPositionPx,
  kHitJumpPx,
  kFoundShare,
  kHitInStepShare,
  kHitOffRayShare,
  kClosedForm,
  kClosedFormLookups,
  kIdentical,
  kCoverageFlips,
  kRelativeError,
  kAbsoluteError,
  kFlip,
  kMaskFlipsPerMillion,
  kTrueClassShare,
  kTrueVerdictShare,
  kHitDistanceError,
  kMeanLookups,
  kP95Lookups,
  kMaxLookups,
  kLookupRatio,
  kLookupsAdded,
  kP95LookupRatio,
  kMissLookupRatio,
  kCpuRatio,
  kPixelCpuRatio,
  kWallRatio,
  kRooflineMultiple,
  kPassCpuShare,
  kPassCpuLead,
  kResampledShare,
  kSkippedShare,
  kConvergence,
  kBudgetMonotone,
  kFinite,
  kNoSelfHit,
  kHitPointInTexel,
  kInsideImage,
  kLookupsWithinBudget,
  kClassConsistent,
};

enum class TruthKind : std::uint8_t {
  kNone,        // the answer is judged by itself
  kOracle,      // Oracle A over the same depth image
  kGeometry,    // Oracle B: the scene's triangles
  kClosedForm,  // a formula, for the scenes that have one
  kRendered,    // the same device's answer over the G-buffer that it rendered itself
  kCross,       // the same stage on another device
  kStage,       // another stage, same device
  kCase,        // another set of parameters
  kSize,        // another size
  kGolden,      // what was blessed before (golden.h)
};

struct Expectation;
struct Measurement;
struct Subject;

struct MetricRow {
  Metric metric{};
  std::string name;
  std::string unit;
  std::vector<TruthKind> truths;                                         // the first is the default
  Measurement (*measure)(const Expectation&, const Subject&) = nullptr;  // one of measure.h
  std::vector<std::string> keys = {};            // keys of [[expect]] that only some metrics take
  std::vector<std::string> needed_keys = {};     // those of them that it cannot do without
  std::vector<std::string> default_passes = {};  // where the key `passes` is not given
  bool on_record = true;                         // may judge the buffer "hit"
  bool on_image = false;                         // may judge an image
  bool zero_by_default = false;                  // without bounds, max is 0
  bool over_cases = false;                       // one check over the whole list `cases`
  bool timed = false;                            // needs the test's `rounds`
  bool needs_oracle = false;                     // even where the truth is another
  bool shows_figure = false;                     // `test` prints what was measured also where it holds
};

[[nodiscard]] std::span<const MetricRow> metricRows();
[[nodiscard]] const MetricRow& row(Metric metric);
[[nodiscard]] const MetricRow* findMetric(std::string_view metric_name);
[[nodiscard]] std::span<const std::string> metricNames();

[[nodiscard]] bool takesKey(const MetricRow& row, std::string_view key);
[[nodiscard]] bool needsKey(const MetricRow& row, std::string_view key);

}  // namespace ssrkit
