// One check that was made, as every report shows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/size.h"
#include "check/outcome.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// How many of what was counted fall into one class.
struct HistogramBin {
  std::string label;
  std::size_t count = 0;
};

// Where texels differ, at most 160 x 90 dots: 0 nothing, 255 the worst.
struct FindingMap {
  Size size;
  std::vector<std::uint8_t> dots;  // row by row from the upper left
};

struct CheckResult {
  std::string id;         // "hiz.matches_oracle.different_rays": the test's id and the expectation's name
  std::string scene;      // "clutter"
  std::string device;     // "gl-osmesa"
  std::string stage;      // "hiz", empty where no stage is concerned
  Size size;              // texels
  std::string case_name;  // "t_0.3m", empty for the only case
  std::optional<TraceParameters> parameters;  // of the trace that is judged; none where none is
  Outcome outcome = Outcome::kError;
  std::string metric;           // "different_rays"
  std::optional<double> value;  // as measured, in `unit`; none when nothing could be measured
  std::optional<double> max;    // the bounds it is held to, either or both
  std::optional<double> min;
  std::string unit;  // "rays", "px", "ratio"
  std::optional<std::pair<double, double>>
      interval;                         // holds the true value with 99 %, where the noise is known
  std::size_t compared = 0;             // rays, pixels or rounds that had a say
  std::string remark;                   // what else the metric tells, whatever the outcome
  std::vector<HistogramBin> histogram;  // where the value is one of a distribution
  std::string message;  // several lines on a failure: where, yours, expected, how widespread, likely cause
  std::string repro;    // the command that runs this check alone
  std::optional<FindingMap> finding_map;  // of what counts against it, on a failure
  double time_s = 0.0;  // its share of the jobs that answered it: their time among all their checks
};

// "<= 0 rays", ">= 13 ratio", "0.5 .. 2 px"; empty without bounds.
[[nodiscard]] std::string boundText(const CheckResult& result);

// "hiz.matches_oracle.different_rays clutter 320x180 t_0.3m gl-osmesa hiz": names the check in lists and
// logs.
[[nodiscard]] std::string fullName(const CheckResult& result);

}  // namespace ssrkit
