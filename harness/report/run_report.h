// Everything that a run found out, as plain data: what the table, results.json and the HTML report are made
// from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/size.h"
#include "check/check_result.h"
#include "check/geometry_verdict.h"
#include "check/ledger.h"
#include "check/outcome.h"
#include "check/verdict.h"
#include "device/device.h"
#include "device/traits.h"
#include "frame/job.h"
#include "image/ray_record.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// Depth-buffer reads a ray, over the rays that were traced: MASKED and BACKGROUND pixels have none.
struct LookupSummary {
  double mean = 0.0;
  double p50 = 0.0;  // nearest rank: a count that some ray has
  double p95 = 0.0;
  double max = 0.0;
};

struct TraceSummary {
  std::array<std::size_t, kRayClassCount> classes{};  // pixels, by the class's number
  std::size_t traced_rays = 0;                        // neither MASKED nor BACKGROUND
  LookupSummary lookups;                              // all 0 when no ray was traced
  std::optional<VerdictCounts> verdicts;              // none without an oracle
};

// `verdicts` has one entry a pixel, or none at all without an oracle.
[[nodiscard]] TraceSummary summarise(const RayRecord& record, std::span<const Verdict> verdicts);

// The rays of one trace by what they truly meet.
struct TrueClassSummary {
  GeometryCounts geometry;                                      // and their verdicts against it
  std::array<VerdictCounts, kTrueClassCount> against_oracle{};  // and against Oracle A
};

// One entry a pixel each.
[[nodiscard]] TrueClassSummary summarise(const GeometryResult& geometry,
                                         std::span<const GeometryVerdict> against_geometry,
                                         std::span<const Verdict> against_oracle);

// One trace: scene x size x case x stage x device.
struct RunRow {
  std::string scene;
  std::string device;
  std::string stage;
  std::string case_name;  // as in CheckResult: empty for the only case
  Size size;
  TraceParameters parameters;                    // as used
  Outcome outcome = Outcome::kError;             // the worst of the trace's checks
  std::optional<TraceSummary> summary;           // none when the trace never came back
  std::optional<TrueClassSummary> true_classes;  // none where Oracle B was not asked
  std::vector<PassReport> passes;
};

// The passes that the stages of one scene share.
struct FrameRow {
  std::string scene;
  std::string device;
  Size size;
  std::vector<PassReport> passes;
};

// What the rays of one scene truly meet, and what Oracle A makes of it.
struct GeometryRow {
  std::string scene;
  std::string device;
  Size size;
  std::string case_name;
  TraceParameters parameters;  // those that the oracles depend on
  GeometryCounts counts;
};

struct DeviceRow {
  DeviceIdentity identity;
  DeviceTraits traits;
};

// One cell of the conformance matrix: test/scene/size/device.
struct CellRow {
  std::string id;
  Outcome outcome = Outcome::kMissing;  // the gravest of its checks
  std::size_t checks = 0;
  double time_s = 0.0;  // of its worker, over all attempts
  int attempts = 1;
};

// Of `test`: one for each test that CTest knows.
struct UnitTestCounts {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t skipped = 0;
};

struct RunReport {
  std::string kit_version;
  std::string started;               // UTC, ISO 8601: "2026-01-31T12:00:00Z"
  std::vector<std::string> command;  // argv
  std::vector<DeviceRow> devices;
  std::vector<CheckResult> checks;
  std::vector<RunRow> rows;
  std::vector<FrameRow> frames;
  std::vector<GeometryRow> geometries;
  Ledger ledger;               // empty where fewer than two devices answered, or nobody asked
  std::vector<CellRow> cells;  // of `conform`
  std::optional<UnitTestCounts> unit_tests;
};

// Of all checks and unit tests: what the closing line and the exit code are made from.
[[nodiscard]] std::vector<Outcome> outcomesOf(const RunReport& report);

// What the technique itself costs: the medians over the rounds (or the cold time, without rounds) of the pass
// that traces and of those that build its pyramid, summed. None when no such pass was timed.
struct TraceCost {
  double cpu_ms = 0.0;
  double wall_ms = 0.0;
};
[[nodiscard]] std::optional<TraceCost> traceCost(std::span<const PassReport> passes);

// The median over a pass's rounds, or its cold time without any.
[[nodiscard]] double cpuMs(const PassReport& pass);

// SAME as a fraction of all rays that were compared; none when there were none.
[[nodiscard]] std::optional<double> sameFraction(const VerdictCounts& verdicts);

}  // namespace ssrkit
