// Everything that a benchmark measured, as plain data: what its table, bench.json, bench.csv and bench.html
// are made from.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/size.h"
#include "check/check_result.h"
#include "check/paired_ratio.h"
#include "check/power_law.h"
#include "report/run_report.h"

namespace ssrkit {

inline constexpr int kBenchSchemaVersion = 2;
inline constexpr double kBenchMargin =
    0.05;  // a ratio is settled when its interval is narrower than twice this

// Where it was measured: times of different machines are not comparable.
struct BenchMachine {
  std::string cpu;
  int core_count = 0;
};

// One pass of one trace, or of the frame (stage empty): what the clock said in every round.
struct BenchSeries {
  std::string scene;
  std::string device;
  std::string stage;
  std::string case_name;
  Size size;
  std::string pass;
  std::optional<TraceParameters> parameters;  // of the trace, as used; none for passes of the frame
  std::size_t rays = 0;                       // that were traced; 0 for passes of the frame
  double lookups = 0.0;                       // of all rays
  PassTime first;                // of the run's first draw: the driver's own compilation included
  std::vector<PassTime> steady;  // one a round
};

// What comes before a steady frame, in wall time: a fresh process, once with its caches and once without.
struct BenchStart {
  std::string scene;
  std::string device;
  bool has_caches = false;       // of SPIR-V and of the driver
  std::int64_t create_ns = 0;    // driver and context
  std::int64_t compile_ns = 0;   // GLSL to SPIR-V
  std::int64_t pipeline_ns = 0;  // the driver's programs
  std::int64_t first_ns = 0;     // every pass's first draw, summed
};

struct BenchScalingPoint {
  std::string label;  // "640x360", "2 m"
  double x = 0.0;
  double ns_per_ray = 0.0;  // median of the rounds, in the axis's clock
  double lookups_per_ray = 0.0;
};

// One trace along one axis.
struct BenchScaling {
  std::string axis;    // "resolution"
  std::string x_unit;  // "texels across"
  std::string clock;   // "CPU" or "wall"
  std::string scene;
  std::string device;
  std::string stage;
  std::vector<BenchScalingPoint> points;
  std::optional<PowerLaw> time;     // of ns_per_ray; none where a point has no positive figure
  std::optional<PowerLaw> lookups;  // of lookups_per_ray
};

// What a trace answered, held against Oracle A.
struct BenchAnswer {
  std::string scene;
  std::string device;
  std::string stage;
  std::string case_name;
  Size size;
  std::size_t rays = 0;
  VerdictCounts verdicts{};
  std::size_t mask_errors = 0;  // rays that hit on one side only, ties left out
  double lookups_per_ray = 0.0;
  double p95_lookups = 0.0;
  double max_lookups = 0.0;
};

// A device's trace held against a native peer's, over the same rays.
struct BenchNativeRatio {
  const BenchSeries* series = nullptr;
  std::string peer;                    // "native-avx512"
  std::optional<RatioInterval> ratio;  // of CPU time; none with fewer than 8 rounds
};

enum class BenchMove { kUnchanged, kFaster, kSlower, kInconclusive };
[[nodiscard]] const char* name(BenchMove move);

// A series held against an earlier run's: its CPU time now over its CPU time then.
struct BenchChange {
  const BenchSeries* series = nullptr;
  std::optional<RatioInterval> ratio;  // none with fewer than 9 rounds on either side
  BenchMove move = BenchMove::kInconclusive;
};

// A series that this run and an earlier one cannot be compared by.
struct BenchUncompared {
  BenchSeries series;  // without its times
  std::string why;     // "only in this run", "thickness_m is 0.3 and was inf"
};

struct BenchComparison {
  std::vector<BenchChange> changes;
  std::vector<BenchUncompared> uncompared;
};

struct BenchReport {
  std::string kit_version;
  std::string started;               // UTC, ISO 8601
  std::vector<std::string> command;  // argv
  BenchMachine machine;
  std::vector<DeviceRow> devices;
  std::vector<BenchStart> starts;
  std::vector<BenchSeries> series;
  std::vector<BenchNativeRatio> over_natives;
  std::vector<BenchAnswer> answers;  // with peers
  std::vector<BenchScaling> scalings;
  std::vector<std::string> replacements;           // "trace_hiz=my.frag", as given
  std::string baseline;                            // the file's name, empty without
  std::vector<std::string> baseline_replacements;  // those of its run
  BenchComparison comparison;                      // with it
  std::vector<CheckResult> gates;
};

// The series of the frame's passes, each once, and of the traces'.
[[nodiscard]] std::vector<BenchSeries> benchSeries(std::span<const FrameRow> frames,
                                                   std::span<const RunRow> rows);

// The traces' answers; those without an oracle are left out.
[[nodiscard]] std::vector<BenchAnswer> benchAnswers(std::span<const RunRow> rows);

// Median CPU time in milliseconds with its 99 % interval; none with fewer than 8 rounds.
[[nodiscard]] std::optional<RatioInterval> cpuMsInterval(const BenchSeries& series);

// In nanoseconds, of one clock; 0 without rounds.
[[nodiscard]] double medianNs(std::span<const PassTime> times, std::int64_t PassTime::*clock);

// This series' CPU time over the other's, round by round; none where rounds are too few or cannot be paired.
[[nodiscard]] std::optional<RatioInterval> cpuRatio(const BenchSeries& series, const BenchSeries& other);

// What the trace costs as a multiple of what its lookups would cost as nothing but reads that wait for each
// other, and its pixels as nothing but writes. None unless the rooflines were timed with it.
[[nodiscard]] std::optional<RatioInterval> rooflineMultiple(const BenchSeries& trace,
                                                            std::span<const BenchSeries> all);

// Of every trace that a native peer has made too.
[[nodiscard]] std::vector<BenchNativeRatio> ratiosOverNatives(const std::vector<BenchSeries>& series,
                                                              std::span<const std::string> natives);

// The whole interval beyond 1 by more than the margin is a move, the whole of it within is none.
[[nodiscard]] BenchMove moveOf(const std::optional<RatioInterval>& ratio, double margin);

// Every series is among the changes where both have it and traced it with the same parameters, else among the
// uncompared, those of either side. The changes point into `now`.
[[nodiscard]] BenchComparison compareSeries(const std::vector<BenchSeries>& now,
                                            std::span<const BenchSeries> then);

// For people: at most 100 columns, ends with a line feed.
[[nodiscard]] std::string benchText(const BenchReport& report);
[[nodiscard]] std::string benchJson(const BenchReport& report);
[[nodiscard]] std::string benchCsv(const BenchReport& report);
[[nodiscard]] std::string benchHtml(const BenchReport& report);

}  // namespace ssrkit
